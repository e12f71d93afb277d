// SPDX-License-Identifier: MIT
//
// Voronoi cells of seeds, cut out of a convex solid one by one. Each cut between two seeds has the
// same bits seen from both, so cells fill the solid to rounding.
#pragma once

#include <span>

#include "jostle/physics/result.h"
#include "modules/destruction/src/convex_cell.h"

namespace jostle::modules::destruction_detail {

// Of the size: what is nearer to a plane than rounding can tell lies on it.
inline constexpr double plane_tolerance_ratio = 1e-14;

// Finite, none twice, 1 to chunks_max.
physics::Status check_seeds(std::span<const physics::Vec3> seeds);
// What of the whole is nearer to this seed than to any other.
ConvexCell voronoi_cell(const ConvexCell& solid, std::span<const physics::Vec3> seeds,
                        std::size_t own, double plane_tolerance);
// What of the whole is on the own side of one other seed.
ConvexCell clip_by_bisector(const ConvexCell& solid, std::span<const physics::Vec3> seeds,
                            std::size_t own, std::uint32_t other, double plane_tolerance);

}  // namespace jostle::modules::destruction_detail
