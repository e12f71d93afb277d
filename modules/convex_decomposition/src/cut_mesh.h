// SPDX-License-Identifier: MIT
//
// What of a solid lies in a box: the corners of its hull, and its volume.
#pragma once

#include <vector>

#include "modules/convex_decomposition/src/closed_mesh.h"

namespace jostle::decomposition {

struct Piece {
    std::vector<physics::Vec3> points;  // whose hull is that of the piece
    physics::Aabb bounds;               // of the points
    double volume = 0;                  // m^3
};

// The triangles that matter in the box: those in it, and those beyond it along x.
std::vector<Triangle> triangles_for_box(const std::vector<Triangle>& surface,
                                        const physics::Aabb& box);
// Of what triangles_for_box() gives, or more.
Piece cut_piece(const std::vector<Triangle>& surface, const physics::Aabb& box);

}  // namespace jostle::decomposition
