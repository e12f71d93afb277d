// SPDX-License-Identifier: MIT
//
// Queries of single triangles.
#pragma once

#include "jostle/physics/vec3.h"
#include "physics/src/geometry/support.h"

namespace jostle::physics {

// The point of a triangle nearest to p, found from the Voronoi region (corner, edge or face) that
// contains p (Ericson, "Real-Time Collision Detection", 5.1.5). Triangles of zero area are treated
// as segments or points.
Vec3 nearest_on_triangle(const Vec3 corner[3], Vec3 p);

// Returns whether a cylinder that moves perpendicular to its axis, as wheels do, certainly has not
// touched a triangle before its centre reaches `middle`. The test is exact up to `margin` m; a
// closest-point search would alternate between the two rims. The part of the triangle between the
// end planes is projected along the axis: a polygon of up to five corners against a disc.
bool passes_cylinder(const Convex& cylinder, Vec3 middle, Vec3 motion, const Vec3 corner[3],
                     double margin);

}  // namespace jostle::physics
