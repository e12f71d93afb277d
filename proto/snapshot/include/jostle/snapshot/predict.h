// SPDX-License-Identifier: MIT
//
// Predicts the pose of a body from up to three earlier frames. WIRE.md has the formulas. All
// arithmetic is on integers, and every product is below 2^53, so C++ and JavaScript agree bit by
// bit. With M above 511 this requires dt1 <= 50 dt2.
#pragma once

#include <array>
#include <cstdint>

#include "jostle/snapshot/entity_state.h"

namespace jostle::snapshot {

/// Indices of the components that are sent, by index of the omitted one.
inline constexpr std::uint8_t others[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};

/// Ticks between the frames: 1 to 255, and 1 where a frame is missing.
struct Spacing {
    std::int64_t dt1 = 1, dt2 = 1,
                 dt3 = 1;  ///< frame - baseline, baseline - baseline2, baseline2 - baseline3
};

struct Prediction {
    std::array<std::int64_t, 3> position{};
    /// x, y, z, w in units of 1 / (M sqrt 2), not normalized.
    std::array<std::int64_t, 4> rotation{};
    std::uint8_t largest = 0;  ///< index of the largest component
    /// The other three components, in the form of EntityState::rotation.
    std::array<std::int64_t, 3> components{};
    /// The last step and its difference from the previous step, which indicates the size of the
    /// prediction error. A rotation that is too large to predict from has a step of 0.
    std::array<std::int64_t, 3> position_step{}, position_acceleration{};
    std::array<std::int64_t, 4> rotation_step{}, rotation_acceleration{};
    /// Sums of the magnitudes of both accelerations; for the rotation without its largest
    /// component.
    std::int64_t position_change = 0, rotation_change = 0;
};

/// baseline2 and baseline3 may be null; baseline3 is used only with baseline2. An entity at rest in
/// the baseline is predicted to stay.
Prediction predict(const EntityState& baseline, const EntityState* baseline2,
                   const EntityState* baseline3, const Spacing& spacing, const QuantSpec& spec);

/// a / b rounded to the nearest integer, halves away from zero; b > 0.
inline std::int64_t divide_rounded(std::int64_t a, std::int64_t b) {
    return a >= 0 ? (a + b / 2) / b : -((-a + b / 2) / b);
}
/// A step over a time d, scaled to a time n.
inline std::int64_t scaled(std::int64_t step, std::int64_t n, std::int64_t d) {
    return n == d ? step : divide_rounded(step * n, d);
}

}  // namespace jostle::snapshot
