// SPDX-License-Identifier: MIT
//
// Internal part of build_hull, used by saved worlds to reconstruct a hull with the same bits.
#pragma once

#include "jostle/physics/hull.h"

namespace jostle::physics {

// Derives planes, edges and mass from the vertices and the face loops, and checks that the faces
// form a closed surface. Preconditions: every index is in range, every loop has at least three
// vertices.
Result<std::shared_ptr<const ConvexHull>> assemble_hull(
    std::vector<Vec3> vertices, const std::vector<std::vector<std::uint16_t>>& faces);

}  // namespace jostle::physics
