// SPDX-License-Identifier: MIT
//
// The inside of build_hull: what a saved world needs to put a hull together again with the same
// bits.
#pragma once

#include "jostle/physics/hull.h"

namespace jostle::physics {

// Derives planes, edges and mass from vertices and the loops of the faces. Checks that they close.
// Every index is in range and every loop has at least three.
Result<std::shared_ptr<const ConvexHull>> assemble_hull(
    std::vector<Vec3> vertices, const std::vector<std::vector<std::uint16_t>>& faces);

}  // namespace jostle::physics
