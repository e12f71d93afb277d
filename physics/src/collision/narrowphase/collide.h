// SPDX-License-Identifier: MIT
//
// Dispatch table from a pair of shape kinds to the collision function.
#pragma once

#include "physics/src/collision/narrowphase/collide_convex.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// Contact points with a gap of at most `margin`. Supports convex kinds and planes; two planes never
// collide.
Manifold collide(const TransformedShape& a, const TransformedShape& b, double margin,
                 PairCache& cache);

}  // namespace jostle::physics
