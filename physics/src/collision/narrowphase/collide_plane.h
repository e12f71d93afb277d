// SPDX-License-Identifier: MIT
//
// A half space against each convex kind: closed forms. a is the plane.
#pragma once

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

Manifold collide_plane_sphere(const TransformedShape& a, const TransformedShape& b, double margin);
Manifold collide_plane_capsule(const TransformedShape& a, const TransformedShape& b, double margin);
Manifold collide_plane_box(const TransformedShape& a, const TransformedShape& b, double margin);
// Cylinders, cones and hulls.
Manifold collide_plane_convex(const TransformedShape& a, const TransformedShape& b, double margin);

}  // namespace jostle::physics
