// SPDX-License-Identifier: MIT
//
// Two outlines in the plane: separating axes among the sides of both (the last one cached), then
// the facing side cut to the other: one or two points.
#pragma once

#include "physics/src/collision/narrowphase/collide_convex.h"

namespace jostle::physics {

// Shapes with an outline (geometry/outline.h) and planes. Normals and points have z = 0.
Manifold collide_planar(const TransformedShape& a, const TransformedShape& b, double margin,
                        PairCache& cache);

}  // namespace jostle::physics
