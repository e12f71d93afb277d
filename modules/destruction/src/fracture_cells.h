// SPDX-License-Identifier: MIT
//
// Fractures solids given as cells by the Voronoi cells of seeds: creates chunks and bonds.
#pragma once

#include <span>

#include "jostle/modules/fractured_shape.h"
#include "modules/destruction/src/convex_cell.h"

namespace jostle::modules::destruction_detail {

// An error names the seed whose chunk is too thin for a hull.
physics::Result<FracturedShape> fracture_cell(const ConvexCell& solid,
                                              std::span<const physics::Vec3> seeds);
// `parts` must not overlap.
physics::Result<FractureResult> fracture_cells(std::span<const ConvexCell> parts,
                                               std::span<const physics::Vec3> seeds,
                                               const FractureProgress& progress);

}  // namespace jostle::modules::destruction_detail
