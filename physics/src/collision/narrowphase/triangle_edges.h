// SPDX-License-Identifier: MIT
//
// The contact normals that the edges of a triangle of a surface allow, so that seams between
// triangles do not push.
#pragma once

#include "jostle/base/check.h"
#include "physics/src/geometry/surface.h"

namespace jostle::physics {

// An edge that turns by less than this is flat. Twice the tangent of half the angle: 1e-4 rad.
inline constexpr double flat_ridge = 0.5e-4;
// An edge without a neighbour: infinity would produce NaN.
inline constexpr double border_ridge = 1e300;
// A normal closer to a face normal than this acts like it.
inline constexpr double facing_normal = 1 - 1e-9;

// The ridge that the shape meets at an edge: see TriangleMesh::folds. `side`: 1 for a shape in
// front of the triangle, -1 for one behind it.
inline double ridge_of(const SurfaceFolds& folds, int k, double side) {
    ASSERT(side == 1 || side == -1);
    return folds.at[k] == no_neighbour_fold ? border_ridge : side * double{folds.at[k]};
}

// Calls visit(edge, outward) for the edges of a triangle at the point `at`. `outward` lies in the
// triangle's plane. Returns false as soon as visit() does.
template <class Visit>
bool for_each_edge_at(const SurfaceTriangle& t, Vec3 front, Vec3 at, Visit&& visit) {
    for (int k = 0; k < 3; k++) {
        const Vec3 from = t.corner[k], along = t.corner[(k + 1) % 3] - from;
        const Vec3 outward = normalized(cross(along, front));
        const double height = length(cross(along, t.corner[(k + 2) % 3] - from)) / length(along);
        if (dot(at - from, outward) >= -1e-4 * height && !visit(k, outward)) return false;
    }
    return true;
}

// Returns whether the point `at` of a triangle is on an edge without a neighbour.
bool is_on_border(const SurfaceTriangle& t, const SurfaceFolds& folds, Vec3 at);

// Returns whether the contact normal n is allowed at the point `at` of the triangle. `face` is its
// normal on the shape's side; `slack` is the sine of an angle.
bool may_act(const SurfaceTriangle& t, const SurfaceFolds& folds, Vec3 face, double side, Vec3 at,
             Vec3 n, double slack);

}  // namespace jostle::physics
