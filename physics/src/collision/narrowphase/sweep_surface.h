// SPDX-License-Identifier: MIT
//
// When a convex shape that goes straight on, without turning, first touches the triangles of a mesh
// or height field: what shape casts ask. Triangles are taken in the order in which they could be
// touched, and the walk ends when none of those left can come before the one that was found.
#pragma once

#include <optional>

#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

struct SurfaceTouch {
    double fraction = 0;   // of the motion
    bool settled = false;  // not inside of one another at the start; then:
    Vec3 point, normal;    // m, world, on the triangle; unit, towards the shape
};

// The first moment at which the shape is within twice `gap` of a triangle, from either side;
// nothing if there is none on its way. Fraction 0 if it is so at the start.
std::optional<SurfaceTouch> sweep_to_surface(const TransformedShape& surface,
                                             const TransformedShape& convex, Vec3 motion,
                                             double gap);

}  // namespace jostle::physics
