// SPDX-License-Identifier: MIT
//
// Converts hulls that may overlap to disjoint cells.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "modules/destruction/src/convex_cell.h"

namespace jostle::modules::destruction_detail {

// Where hulls overlap, the first one has precedence; the rest of the others is cut along its faces.
// Slivers of less than 1e-9 of the volume are dropped.
std::vector<ConvexCell> disjoint_cells(
    std::span<const std::shared_ptr<const physics::ConvexHull>> hulls);

}  // namespace jostle::modules::destruction_detail
