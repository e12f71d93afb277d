// SPDX-License-Identifier: MIT
//
// The least way to part two overlapping convex cores (EPA: van den Bergen, "Proximity queries and
// penetration depth computation on 3D game objects", 2001): a polytope inside the difference of the
// two grows towards the nearest piece of its border.
#pragma once

#include "physics/src/collision/narrowphase/gjk.h"

namespace jostle::physics {

struct Penetration {
    double depth = 0;  // m, >= 0
    Vec3 normal;       // unit, from a to b
    Vec3 on_a, on_b;   // deepest points
};

// `start`: a simplex that holds the origin, from gjk.
Penetration penetration(const Convex& a, const Convex& b, const Simplex& start);

}  // namespace jostle::physics
