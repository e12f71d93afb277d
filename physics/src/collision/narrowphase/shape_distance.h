// SPDX-License-Identifier: MIT
//
// The signed distance of two simple shapes (convex kinds and planes) and the points at that
// distance.
#pragma once

#include "physics/src/collision/narrowphase/collide_convex.h"

namespace jostle::physics {

struct SignedDistance {
    double distance = 0;  // m; negative for overlap
    Vec3 normal;          // unit, from a to b
    Vec3 on_a, on_b;      // m, world, on the surfaces
};

SignedDistance signed_distance(const TransformedShape& a, const TransformedShape& b,
                               PairCache& cache);

}  // namespace jostle::physics
