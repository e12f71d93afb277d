// SPDX-License-Identifier: MIT
//
// The closest points of two convex cores (Gilbert, Johnson, Keerthi 1988; sub-distances after
// Ericson, "Real-Time Collision Detection", 5.1). Warm-started by a direction: with the normal of
// the step before, pairs that hardly moved take one or two rounds.
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
    double distance = 0;  // m by which the normal separates the cores; 0: they overlap
    Vec3 normal;          // unit, from a to b; meaningless when they overlap
    Vec3 on_a, on_b;
    Simplex simplex;  // when they overlap: holds the origin
    int rounds = 0;
};

// When to stop before the distance is exact. What is found then is a lower bound of it.
struct GjkGoal {
    double beyond = 1e300;  // m: as soon as some direction separates the cores by more
    double loose = 0;       // part that may be missing of the gap between the round shapes
    double radii = 0;       // m, of both around the cores
    Vec3 motion = {};       // m: how b goes on; `beyond` is asked for all along it
};

// `hint`: a guess of the direction from a to b; zero: none.
GjkResult gjk(const Convex& a, const Convex& b, Vec3 hint, const GjkGoal& goal = {});

}  // namespace jostle::physics
