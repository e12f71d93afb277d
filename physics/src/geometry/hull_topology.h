// SPDX-License-Identifier: MIT
//
// Topology of hull construction: determines which triples of points are faces. Uses integer
// coordinates, so every predicate is exact.
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

// Point indices, counter-clockwise seen from outside.
using HullTriangle = std::array<std::uint32_t, 3>;

// Returns a closed triangulated hull of distinct points; nullopt if all points are coplanar.
std::optional<std::vector<HullTriangle>> hull_triangles(std::span<const GridPoint> points);

}  // namespace jostle::physics
