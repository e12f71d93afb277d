// SPDX-License-Identifier: MIT
//
// Encodes the points of one object (WIRE.md, "Points"). Positions are integers. Each point is
// predicted in time, from up to three earlier states of the object, and in space: by how far the
// points next to it were from their own predictions. The differences are coded by the range coder.
// Any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/snapshot/point_layout.h"
#include "jostle/snapshot/point_state.h"

namespace jostle::snapshot {

struct PackedPoints {
    std::vector<std::byte> bytes;
    std::uint32_t crc = 0;
    /// Approximate number of bytes if only this many levels, plus one, were coded.
    std::array<std::size_t, point_levels> bytes_of_levels = {};
};

/// Encodes the first `levels` levels, 1 to point_levels. The state must have the values that a
/// decoder computes for the other levels (see coarse_points()). `order` is not used for loose
/// points.
PackedPoints encode_points(const PointLayout& layout, const PointOrder& order,
                           const PointState& state, const PointBaselines& baselines,
                           std::size_t levels = point_levels);

/// A decoded state.
struct DecodedPoints {
    PointState state;
    std::size_t levels = point_levels;  ///< that were coded
    std::uint32_t crc = 0;
};
/// Decodes untrusted bytes. Returns corrupt_data with the reason if they are malformed. A count of
/// points is limited before memory is allocated. The bytes use the first ones of `available`.
Result<DecodedPoints> read_points(const PointLayout& layout, const PointOrder& order,
                                  std::uint32_t number, std::span<const std::byte> bytes,
                                  const PointBaselines& available);

/// Replaces the points beyond the first `levels` levels by their predictions from the other points.
void coarse_points(const PointLayout& layout, const PointOrder& order,
                   std::vector<std::int32_t>& values, std::size_t levels);

}  // namespace jostle::snapshot
