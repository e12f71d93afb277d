// SPDX-License-Identifier: MIT
//
// Minimum translation that separates two overlapping convex cores (EPA: van den Bergen, "Proximity
// queries and penetration depth computation on 3D game objects", 2001). A polytope inside the
// Minkowski difference expands towards the nearest part of its boundary.
#pragma once

#include "physics/src/collision/narrowphase/gjk.h"

namespace jostle::physics {

struct Penetration {
    double depth = 0;  // m, >= 0
    Vec3 normal;       // unit, from a to b
    Vec3 on_a, on_b;   // deepest points
};

// `start`: a simplex from gjk() that contains the origin.
Penetration penetration(const Convex& a, const Convex& b, const Simplex& start);

}  // namespace jostle::physics
