// SPDX-License-Identifier: MIT
//
// The part of a solid inside a box: the points of its hull, and its volume.
#pragma once

#include <vector>

#include "modules/convex_decomposition/src/closed_mesh.h"

namespace jostle::modules::convex_decomposition {

struct Piece {
    std::vector<physics::Vec3> points;  // its hull is the hull of the piece
    physics::Aabb bounds;               // of the points
    double volume = 0;                  // m^3
};

// Returns the triangles that affect the box: those inside, and those beyond it along x.
std::vector<Triangle> triangles_for_box(const std::vector<Triangle>& surface,
                                        const physics::Aabb& box);
// `surface` is the result of triangles_for_box(), or a superset.
Piece cut_piece(const std::vector<Triangle>& surface, const physics::Aabb& box);

}  // namespace jostle::modules::convex_decomposition
