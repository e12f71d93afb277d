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

// Volume, centre of mass and inertia of a closed polyhedron of density 1.
struct PolyhedronMass {
    double volume = 0;                   // m^3
    Vec3 center;                         // m
    Mat3 inertia = diagonal({0, 0, 0});  // m^5, about `center`
};

// Sums over the tetrahedra between the first vertex and the triangles of every face (Blow and
// Binstock, "How to find the inertia tensor of a 3D solid body", 2004).
PolyhedronMass polyhedron_mass(const ConvexHull& hull);

}  // namespace jostle::physics
