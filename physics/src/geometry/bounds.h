// SPDX-License-Identifier: MIT
//
// The box around a shape, and the ball.
#pragma once

#include "jostle/physics/aabb.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// An axis-aligned box that holds the shape; the tightest one for convex kinds. A plane has none (it
// is infinite): not to be asked.
Aabb bounds_of(const TransformedShape& shape);

// The distance of the shape's furthest point from its origin. Not for planes.
double radius_of(const Geometry& geometry);

}  // namespace jostle::physics
