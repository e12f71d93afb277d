// SPDX-License-Identifier: MIT
//
// The state of a body on the wire, as integers. A pose is quantized once per tick. Differences and
// CRCs use only the integers, so decoding is exact and sender and receiver cannot drift apart.
// WIRE.md specifies the format.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace jostle::snapshot {

struct EntityState {
    std::uint32_t id = 0;                    ///< never reused in a world, never 0
    std::array<std::int32_t, 3> position{};  ///< units of 1/units_per_meter m
    std::uint8_t largest = 3;  ///< index of the omitted quaternion component: 0 x, 1 y, 2 z, 3 w
    /// The other three components in the order x y z w, in units of 1 / (M sqrt 2), each -M..M. The
    /// sign of the quaternion makes the omitted component non-negative.
    std::array<std::int16_t, 3> rotation{};
    bool at_rest = false;  ///< the body sleeps

    bool operator==(const EntityState&) const = default;
};

/// Compares the numbers one by one: comparing arrays calls memcmp, which is slower.
inline bool same_rotation(const EntityState& a, const EntityState& b) {
    return a.rotation[0] == b.rotation[0] && a.rotation[1] == b.rotation[1] &&
           a.rotation[2] == b.rotation[2] && a.largest == b.largest;
}
inline bool same_pose(const EntityState& a, const EntityState& b) {
    return a.position[0] == b.position[0] && a.position[1] == b.position[1] &&
           a.position[2] == b.position[2] && same_rotation(a, b);
}

/// A world at one tick: entities sorted by id. Frame 0 is never sent; as a baseline it means
/// "none".
struct QuantizedFrame {
    std::uint32_t frame = 0;
    std::vector<EntityState> entities;

    bool operator==(const QuantizedFrame&) const = default;
};

inline constexpr std::int32_t max_units_per_meter = 65536;
inline constexpr std::int32_t max_rotation_component = 16383;  ///< 15 bits including the sign

/// Quantization of poses, identical on both sides (Welcome.quant). Each value is 1 to its maximum
/// above.
struct QuantSpec {
    std::int32_t units_per_meter = 512;
    std::int32_t rotation_component = 511;  ///< M

    bool operator==(const QuantSpec&) const = default;
};

}  // namespace jostle::snapshot
