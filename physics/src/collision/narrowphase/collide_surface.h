// SPDX-License-Identifier: MIT
//
// A convex shape against the triangles of a mesh or height field. Triangles of one sheet act as a
// smooth surface: a flat or concave edge between two of them does not produce contacts of its own.
#pragma once

#include <vector>

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/collision/narrowphase/surface_motion.h"
#include "physics/src/geometry/surface.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// Appends one manifold per flat piece, deepest first. Normals point from the surface to the shape.
// `motion`: motion of the shape; null if it does not move.
// `neighbours`: shapes next to the surface that the shape may touch; may include the surface.
// Returns whether one of them covers a contact (seams.h).
bool collide_surface(const TransformedShape& surface, const TransformedShape& convex, double margin,
                     const SurfaceMotion* motion, const std::vector<TransformedShape>& neighbours,
                     std::vector<Manifold>& out);

// The contact normal of a shape that touches a triangle at a local point `at`, where n is the
// direction of the shortest distance to the shape. Returns the face normal if a seam does not allow
// n.
Vec3 acting_normal(const Geometry& surface, const SurfaceTriangle& triangle, Vec3 at, Vec3 n);

// Returns whether the shapes share a point. Seams count in this test.
bool overlaps_surface(const TransformedShape& surface, const TransformedShape& convex);

}  // namespace jostle::physics
