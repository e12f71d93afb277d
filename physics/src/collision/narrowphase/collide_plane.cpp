// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/collide_pairs.h"

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/clip.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

Vec3 world_normal(const TransformedShape& plane) {
    return plane.axes * std::get<Plane>(*plane.geometry).normal;
}

// Adds the lowest point of a ball (or of a corner, r = 0) if it is within the margin.
void add_point(Manifold& m, const TransformedShape& plane, Vec3 center, double r, double margin) {
    const double gap = dot(center - plane.position, m.normal) - r;
    m.distance = m.count == 0 ? minimum(m.distance, gap) : m.distance;
    if (gap > margin) return;
    m.gap[m.count] = gap;
    ASSERT(m.count < 4);
    m.point[m.count] = center - m.normal * (r + 0.5 * gap);
    m.count++;
}

}  // namespace

Manifold collide_plane_sphere(const TransformedShape& a, const TransformedShape& b, double margin) {
    Manifold m{.normal = world_normal(a), .distance = 1e300};
    add_point(m, a, b.position, std::get<Sphere>(*b.geometry).radius, margin);
    return m;
}

Manifold collide_plane_capsule(const TransformedShape& a, const TransformedShape& b,
                               double margin) {
    const Capsule& capsule = std::get<Capsule>(*b.geometry);
    const Vec3 half = b.axes.y * capsule.half_length;
    Manifold m{.normal = world_normal(a), .distance = 1e300};
    add_point(m, a, b.position - half, capsule.radius, margin);
    add_point(m, a, b.position + half, capsule.radius, margin);
    return m;
}

// The four corners of the face whose normal is most antiparallel to the plane's normal.
Manifold collide_plane_box(const TransformedShape& a, const TransformedShape& b, double margin) {
    Manifold m{.normal = world_normal(a), .distance = 1e300};
    const Vec3 h = std::get<Box>(*b.geometry).half_extents;
    const Vec3 n = transposed_times(b.axes, m.normal);
    int face = 0;
    for (int k = 1; k < 3; k++)
        if (absolute(n[k]) > absolute(n[face])) face = k;
    const int u = (face + 1) % 3, v = (face + 2) % 3;
    Vec3 corner;
    corner[face] = n[face] > 0 ? -h[face] : h[face];
    static constexpr int sign_u[4] = {1, -1, -1, 1}, sign_v[4] = {1, 1, -1, -1};
    for (int k = 0; k < 4; k++) {
        corner[u] = sign_u[k] * h[u];
        corner[v] = sign_v[k] * h[v];
        add_point(m, a, b.position + b.axes * corner, 0, margin);
    }
    return m;
}

// The corners of the feature that faces the plane, and the lowest point of the shape.
Manifold collide_plane_convex(const TransformedShape& a, const TransformedShape& b, double margin) {
    const Vec3 n = world_normal(a);
    const Convex shape = convex_of(b, b.position);
    const double height = dot(b.position - a.position, n);
    const Vec3 lowest = support(shape, -n);
    const double deepest = height + dot(lowest, n);
    ASSERT(is_unit(n));
    if (deepest > margin) return {.normal = n, .distance = deepest};
    ContactPoints points;
    const Feature feature = feature_along(shape, -n);
    ASSERT(feature.count < ContactPoints::capacity);
    const auto add = [&](Vec3 p) {
        const double gap = height + dot(p, n);
        if (gap > margin) return;
        points.gap[points.count] = gap;
        points.point[points.count++] = p - n * (0.5 * gap);
    };
    double least = 1e300;
    for (int k = 0; k < feature.count; k++) {
        add(feature.corner[k]);
        least = minimum(least, height + dot(feature.corner[k], n));
    }
    if (least > deepest + 1e-6 * size_of(shape)) add(lowest);
    Manifold m = manifold_of(points, n, size_of(shape));
    for (int k = 0; k < m.count; k++) m.point[k] += b.position;
    return m;
}

}  // namespace jostle::physics
