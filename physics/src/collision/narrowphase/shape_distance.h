// SPDX-License-Identifier: MIT
//
// The signed distance of two simple shapes (convex kinds and planes) and the points at that
// distance.
#pragma once

#include "physics/src/collision/narrowphase/collide_convex.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

struct SignedDistance {
    double distance = 0;  // m; negative for overlap
    Vec3 normal;          // unit, from a to b
    Vec3 on_a, on_b;      // m, world, on the surfaces
};

SignedDistance signed_distance(const TransformedShape& a, const TransformedShape& b,
                               PairCache& cache);

// The point of a shape's surface nearest to a given point.
struct SurfacePoint {
    double distance = 0;  // m; negative if the point is inside
    Vec3 point;           // m, world
    Vec3 normal;          // unit, out of the shape
};

// Supports all kinds. Meshes and height fields are surfaces: their distance is never negative.
SurfacePoint nearest_point(const TransformedShape& shape, Vec3 point);

}  // namespace jostle::physics
