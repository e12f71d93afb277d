// SPDX-License-Identifier: MIT
//
// Collision of two outlines in the plane. Tests the sides of both as separating axes, the cached
// one first, then clips the facing side to the other outline: one or two points.
#pragma once

#include "physics/src/collision/narrowphase/collide_convex.h"

namespace jostle::physics {

// Supports shapes with an outline (geometry/outline.h) and planes. Normals and points have z = 0.
Manifold collide_planar(const TransformedShape& a, const TransformedShape& b, double margin,
                        PairCache& cache);

}  // namespace jostle::physics
