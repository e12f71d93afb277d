// SPDX-License-Identifier: MIT
//
// The closest points of two convex cores (Gilbert, Johnson, Keerthi 1988; sub-distances after
// Ericson, "Real-Time Collision Detection", 5.1). Warm-started by a direction: with the normal of
// the step before, pairs that hardly moved take one or two rounds.
#pragma once

#include "geometry/support.h"

namespace jostle::physics {

struct SimplexPoint {
    Vec3 a, b;  // on the two cores
    Vec3 w;     // a - b
};

struct Simplex {
    SimplexPoint point[4];
    double weight[4] = {};
    int count = 0;
};

struct GjkResult {
    double distance = 0;  // m between the cores; 0: they overlap
    Vec3 normal;          // unit, from a to b; meaningless when they overlap
    Vec3 on_a, on_b;
    Simplex simplex;  // when they overlap: holds the origin
    int rounds = 0;
};

// `hint`: a guess of the direction from a to b; zero: none.
GjkResult gjk(const Convex& a, const Convex& b, Vec3 hint);

}  // namespace jostle::physics
