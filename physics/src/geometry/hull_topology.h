// SPDX-License-Identifier: MIT
//
// The combinatorial half of hull building: which triples of points are faces. Works on integers, so
// every question has an exact answer.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace jostle::physics {

// Coordinates within +-2^30.
struct GridPoint {
    std::int64_t x = 0, y = 0, z = 0;

    auto operator<=>(const GridPoint&) const = default;
};

using HullTriangle = std::array<std::uint32_t, 3>;  // points, counter-clockwise seen from outside

// A closed triangulated hull; nothing when all points lie in one plane. Distinct points only.
std::optional<std::vector<HullTriangle>> hull_triangles(std::span<const GridPoint> points);

}  // namespace jostle::physics
