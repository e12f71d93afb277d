// SPDX-License-Identifier: MIT
//
// Bounding boxes and bounding radii of shapes.
#pragma once

#include "jostle/physics/aabb.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// Returns an axis-aligned bounding box of the shape, tight for convex kinds. Not for planes, which
// are infinite.
Aabb bounds_of(const TransformedShape& shape);

// Returns the distance of the shape's furthest point from its origin, m. Not for planes.
double radius_of(const Geometry& geometry);

}  // namespace jostle::physics
