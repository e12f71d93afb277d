// SPDX-License-Identifier: MIT
//
// Volume, centre of mass and inertia of a closed polyhedron of density 1.
#pragma once

#include "jostle/physics/hull.h"

namespace jostle::physics {

struct PolyhedronMass {
    double volume = 0;                   // m^3
    Vec3 center;                         // m
    Mat3 inertia = diagonal({0, 0, 0});  // m^5, about `center`
};

// Sums over the tetrahedra between the first vertex and the triangles of every face (Blow and
// Binstock, "How to find the inertia tensor of a 3D solid body", 2004).
PolyhedronMass polyhedron_mass(const ConvexHull& hull);

}  // namespace jostle::physics
