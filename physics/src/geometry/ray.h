// SPDX-License-Identifier: MIT
//
// Ray against each shape kind.
#pragma once

#include <optional>

#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

struct ShapeRayHit {
    double fraction = 0;  // 0..1 of the motion
    Vec3 normal;          // unit, out of the shape
};

// A triangle, from either side (Moeller and Trumbore, "Fast, minimum storage ray/triangle
// intersection", 1997).
std::optional<ShapeRayHit> cast_at_triangle(Vec3 origin, Vec3 motion, const Vec3 corner[3]);

// The first point of origin..origin+motion that the shape holds. An origin inside answers fraction
// 0 and a normal against the motion; meshes and height fields are surfaces, with no inside.
std::optional<ShapeRayHit> cast_ray(const TransformedShape& shape, Vec3 origin, Vec3 motion);

}  // namespace jostle::physics
