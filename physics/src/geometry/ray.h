// SPDX-License-Identifier: MIT
//
// Ray casts against each shape kind.
#pragma once

#include <optional>

#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

struct ShapeRayHit {
    double fraction = 0;  // 0..1 of the motion
    Vec3 normal;          // unit, out of the shape
};

// Casts a ray against both sides of a triangle (Moeller and Trumbore, "Fast, minimum storage
// ray/triangle intersection", 1997).
std::optional<ShapeRayHit> cast_at_triangle(Vec3 origin, Vec3 motion, const Vec3 corner[3]);

// Returns the first point of origin..origin + motion inside the shape. If the origin is inside, the
// fraction is 0 and the normal is opposite to the motion; meshes and height fields are surfaces
// without an inside.
std::optional<ShapeRayHit> cast_ray(const TransformedShape& shape, Vec3 origin, Vec3 motion);

}  // namespace jostle::physics
