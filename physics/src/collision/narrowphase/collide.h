// SPDX-License-Identifier: MIT
//
// The table: shape kind x shape kind to function.
#pragma once

#include "physics/src/collision/narrowphase/collide_convex.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// Points with a gap of at most `margin`. Convex kinds and planes; two planes never collide.
Manifold collide(const TransformedShape& a, const TransformedShape& b, double margin,
                 PairCache& cache);

}  // namespace jostle::physics
