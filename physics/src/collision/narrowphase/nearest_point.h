// SPDX-License-Identifier: MIT
//
// The point of a shape's surface nearest to a given point.
#pragma once

#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

struct SurfacePoint {
    double distance = 0;  // m; negative if the point is inside
    Vec3 point;           // m, world
    Vec3 normal;          // unit, out of the shape
};

// Supports all kinds. Meshes and height fields are surfaces: their distance is never negative.
SurfacePoint nearest_point(const TransformedShape& shape, Vec3 point);

}  // namespace jostle::physics
