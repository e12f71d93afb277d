// SPDX-License-Identifier: MIT
//
// The first touch of a convex shape, in a linear motion without rotation, with the triangles of a
// mesh or height field. Shape casts use it. Triangles are visited in the order in which they could
// be touched, and the traversal ends when no remaining triangle can be touched before the best hit.
#pragma once

#include <optional>

#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

struct SurfaceTouch {
    double fraction = 0;   // of the motion
    bool settled = false;  // the shapes do not overlap at the start; the following fields are valid
    Vec3 point, normal;    // m, world, on the triangle; unit, towards the shape
};

// The first fraction at which the shape is within twice `gap` of a triangle, from either side.
// Returns nullopt if there is none in the motion, and fraction 0 if the shape is that close at the
// start.
std::optional<SurfaceTouch> sweep_to_surface(const TransformedShape& surface,
                                             const TransformedShape& convex, Vec3 motion,
                                             double gap);

}  // namespace jostle::physics
