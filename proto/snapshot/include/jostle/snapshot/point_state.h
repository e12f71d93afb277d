// SPDX-License-Identifier: MIT
//
// The points of a point object at one time (WIRE.md, "Points").
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace jostle::snapshot {

/// Largest magnitude of a coordinate, in steps of the object.
inline constexpr std::int32_t point_coordinate_max = 1 << 30;
/// A loose point that the previous state does not have.
inline constexpr std::uint32_t no_point = std::numeric_limits<std::uint32_t>::max();

/// The points of an object at one time.
struct PointState {
    std::uint32_t number = 0;  ///< counts the states of the object
    /// components_of() the form for each point, in steps of the object, each within
    /// point_coordinate_max.
    std::vector<std::int32_t> values;
    /// Loose points only: for each point, its index in the previous state, ascending apart from
    /// no_point.
    std::vector<std::uint32_t> previous;
};

/// The states before a state, the newest first. Each is the previous state of the one before it.
struct PointBaselines {
    const PointState *baseline = nullptr, *baseline2 = nullptr, *baseline3 = nullptr;

    std::size_t count() const { return !baseline ? 0 : !baseline2 ? 1 : !baseline3 ? 2 : 3; }
    /// The first `count` of them.
    PointBaselines first(std::size_t count) const {
        return {count > 0 ? baseline : nullptr, count > 1 ? baseline2 : nullptr,
                count > 2 ? baseline3 : nullptr};
    }
};

}  // namespace jostle::snapshot
