// SPDX-License-Identifier: MIT
//
// A convex shape against the triangles of a mesh or height field. Triangles of one sheet act as a
// smooth surface: where a fold is flat or hollow, the edge between two of them cannot be felt.
#pragma once

#include <vector>

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/collision/narrowphase/surface_motion.h"
#include "physics/src/geometry/surface.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// Appends one manifold per flat piece, deepest first; normals point from the surface to the shape.
// `way`: of the shape, if it moves; else null.
void collide_surface(const TransformedShape& surface, const TransformedShape& convex, double margin,
                     const SurfaceMotion* motion, std::vector<Manifold>& out);

// The normal of a shape that touches a triangle at a point of it, local, where the shortest way to
// the shape is along n: that of the face where a seam cannot be felt.
Vec3 acting_normal(const Geometry& surface, const SurfaceTriangle& triangle, Vec3 at, Vec3 n);

// Whether they share a point: seams count here.
bool overlaps_surface(const TransformedShape& surface, const TransformedShape& convex);

}  // namespace jostle::physics
