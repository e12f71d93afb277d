// SPDX-License-Identifier: MIT
//
// The closest points of two convex cores (Gilbert, Johnson, Keerthi 1988; sub-distances after
// Ericson, "Real-Time Collision Detection", 5.1). A direction warm-starts the search: with the
// normal of the previous step, pairs that barely moved take one or two rounds.
#pragma once

#include "physics/src/foundation/uninitialized_array.h"
#include "physics/src/geometry/support.h"

namespace jostle::physics {

struct SimplexPoint {
    Vec3 a, b;  // on the two cores
    Vec3 w;     // a - b
};

struct Simplex {
    UninitializedArray<SimplexPoint, 4> point;
    double weight[4] = {};
    int count = 0;
};

struct GjkResult {
    double distance = 0;  // separation along the normal, m; 0 if the cores overlap
    Vec3 normal;          // unit, from a to b; undefined if the cores overlap
    Vec3 on_a, on_b;
    Simplex simplex;  // contains the origin if the cores overlap
    int rounds = 0;
};

// Criteria for stopping before the distance is exact. The result is then a lower bound of the
// distance.
struct GjkGoal {
    double beyond = 1e300;  // m: stop when any direction separates the cores by more
    double loose = 0;       // tolerated relative error of the gap between the round shapes
    double radii = 0;       // m, sum of the radii around both cores
    Vec3 motion = {};       // m: further motion of b; `beyond` must hold along all of it
};

// `hint`: a guess of the direction from a to b; zero for none.
GjkResult gjk(const Convex& a, const Convex& b, Vec3 hint, const GjkGoal& goal = {});

}  // namespace jostle::physics
