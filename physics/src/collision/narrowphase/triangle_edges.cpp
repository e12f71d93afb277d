// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/triangle_edges.h"

#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

// Returns whether an edge allows a contact normal n. `outward` lies in the triangle's plane; `face`
// is its normal on the shape's side.
bool edge_allows(double ridge, Vec3 face, Vec3 outward, Vec3 n, double slack) {
    const double up = dot(n, face), out = dot(n, outward);
    if (out < -slack) return false;  // leans inward: the face itself pushes
    if (ridge == border_ridge) return up > -slack;
    if (ridge < flat_ridge) return out < slack;  // flat or concave
    // Convex fold: any direction between the normals of the two faces is allowed.
    const double square = ridge * ridge, other_up = (1 - square) / (1 + square),
                 other_out = 2 * ridge / (1 + square);
    return out * other_up - up * other_out < slack;  // sine of the angle beyond the other normal
}

}  // namespace

bool is_on_border(const SurfaceTriangle& t, const SurfaceFolds& folds, Vec3 at) {
    const auto is_border = [&](int k) { return folds.at[k] == no_neighbour_fold; };
    if (!is_border(0) && !is_border(1) && !is_border(2)) return false;
    return !for_each_edge_at(t, normal_of(t), at, [&](int k, Vec3) { return !is_border(k); });
}

bool may_act(const SurfaceTriangle& t, const SurfaceFolds& folds, Vec3 face, double side, Vec3 at,
             Vec3 n, double slack) {
    if (dot(n, face) > facing_normal) return true;
    ASSERT(is_unit(face, 1e-5) && is_unit(n, 1e-5));
    bool on_edge = false;
    const bool allowed = for_each_edge_at(t, face * side, at, [&](int k, Vec3 outward) {
        on_edge = true;
        return edge_allows(ridge_of(folds, k, side), face, outward, n, slack);
    });
    return on_edge && allowed;
}

}  // namespace jostle::physics
