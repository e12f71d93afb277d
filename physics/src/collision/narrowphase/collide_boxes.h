// SPDX-License-Identifier: MIT
//
// Box against box: separating axes, then clipping of the incident face against the reference face
// (Gottschalk 1996 for the fifteen axes; Sutherland and Hodgman 1974 for the clipping).
#pragma once

#include "physics/src/collision/narrowphase/collide_convex.h"

namespace jostle::physics {

Manifold collide_boxes(const TransformedShape& a, const TransformedShape& b, double margin,
                       PairCache& cache);

}  // namespace jostle::physics
