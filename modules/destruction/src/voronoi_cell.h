// SPDX-License-Identifier: MIT
//
// Voronoi cells of seeds, clipped from a convex solid one by one. The plane between two seeds is
// bit-identical for both cells, so the cells fill the solid up to rounding error.
#pragma once

#include <span>

#include "jostle/physics/result.h"
#include "modules/destruction/src/convex_cell.h"

namespace jostle::modules::destruction_detail {

// Relative to the size: points within this distance of a plane are on it, because of rounding.
inline constexpr double plane_tolerance_ratio = 1e-14;

// Seeds must be finite and distinct, 1 to chunks_max.
physics::Status check_seeds(std::span<const physics::Vec3> seeds);
// The part of the solid that is nearer to this seed than to any other.
ConvexCell voronoi_cell(const ConvexCell& solid, std::span<const physics::Vec3> seeds,
                        std::size_t own, double plane_tolerance);
// The part of the solid that is nearer to this seed than to one other seed.
ConvexCell clip_by_bisector(const ConvexCell& solid, std::span<const physics::Vec3> seeds,
                            std::size_t own, std::uint32_t other, double plane_tolerance);

}  // namespace jostle::modules::destruction_detail
