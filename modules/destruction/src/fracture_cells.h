// SPDX-License-Identifier: MIT
//
// Solids that are cells, cut by the cells of seeds: chunks, and the bonds between them.
#pragma once

#include <span>

#include "jostle/modules/fractured_shape.h"
#include "modules/destruction/src/convex_cell.h"

namespace jostle::modules::destruction_detail {

// An error names the seed whose chunk is too thin for a hull.
physics::Result<FracturedShape> fracture_cell(const ConvexCell& solid,
                                              std::span<const physics::Vec3> seeds);
// Of parts that do not overlap.
physics::Result<FractureResult> fracture_cells(std::span<const ConvexCell> parts,
                                               std::span<const physics::Vec3> seeds,
                                               const FractureProgress& progress);

}  // namespace jostle::modules::destruction_detail
