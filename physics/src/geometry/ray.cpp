// SPDX-License-Identifier: MIT
//
// Each kind is solved in the shape's own frame with the ray o + t m, 0 <= t <= 1.
#include "geometry/ray.h"

namespace jostle::physics {
namespace {

using Hit = std::optional<ShapeRayHit>;

Hit from_inside(Vec3 motion) {
    return ShapeRayHit{0, normalized(-motion)};
}

// Smaller root of |o + t m - c|^2 = r^2 for an origin outside.
Hit cast_at_sphere(Vec3 o, Vec3 m, Vec3 center, double radius) {
    const Vec3 d = o - center;
    const double a = dot(m, m), b = dot(d, m), c = dot(d, d) - radius * radius;
    if (c <= 0) return from_inside(m);
    const double discriminant = b * b - a * c;
    if (b >= 0 || discriminant < 0) return {};
    // c / (-b + sqrt) instead of (-b - sqrt) / a: no cancellation for far origins.
    const double t = c / (-b + square_root(discriminant));
    if (t > 1) return {};
    return ShapeRayHit{t, normalized(d + m * t)};
}

Hit cast_at_capsule(Vec3 o, Vec3 m, const Capsule& capsule) {
    const double h = capsule.half_length, r = capsule.radius;
    const Vec3 nearest{0, clamp(o.y, -h, h), 0};
    if (length_squared(o - nearest) <= r * r) return from_inside(m);
    Hit best;
    // The side: a circle in the xz plane, if the ray meets it between the two ends.
    const double a = m.x * m.x + m.z * m.z, b = o.x * m.x + o.z * m.z;
    const double c = o.x * o.x + o.z * o.z - r * r, discriminant = b * b - a * c;
    if (c > 0 && b < 0 && discriminant >= 0) {
        const double t = c / (-b + square_root(discriminant)), y = o.y + t * m.y;
        if (t <= 1 && absolute(y) <= h)
            best = ShapeRayHit{t, normalized(Vec3{o.x + t * m.x, 0, o.z + t * m.z})};
    }
    for (const double end : {-h, h}) {
        const Hit cap = cast_at_sphere(o, m, {0, end, 0}, r);
        if (cap && (!best || cap->fraction < best->fraction)) best = cap;
    }
    return best;
}

Hit cast_at_box(Vec3 o, Vec3 m, Vec3 h) {
    double enter = -1, leave = 1;
    int axis = -1;
    for (int k = 0; k < 3; k++) {
        if (m[k] == 0) {
            if (absolute(o[k]) > h[k]) return {};
            continue;
        }
        const double s = 1 / m[k], side = m[k] > 0 ? h[k] : -h[k];
        const double t_in = (-side - o[k]) * s, t_out = (side - o[k]) * s;
        if (t_in > enter) {
            enter = t_in;
            axis = k;
        }
        leave = minimum(leave, t_out);
    }
    if (enter > leave || leave < 0) return {};
    if (enter < 0 || axis < 0) return from_inside(m);
    Vec3 normal;
    normal[axis] = m[axis] > 0 ? -1 : 1;
    return ShapeRayHit{enter, normal};
}

Hit cast_at_plane(Vec3 o, Vec3 m, Vec3 normal) {
    const double height = dot(o, normal), climb = dot(m, normal);
    if (height <= 0) return from_inside(m);
    if (climb >= 0 || height > -climb) return {};
    return ShapeRayHit{height / -climb, normal};
}

}  // namespace

std::optional<ShapeRayHit> cast_ray(const Placed& shape, Vec3 origin, Vec3 motion) {
    const Vec3 o = transposed_times(shape.axes, origin - shape.position);
    const Vec3 m = transposed_times(shape.axes, motion);
    Hit hit;
    switch (kind_of(*shape.geometry)) {
        case ShapeKind::sphere:
            hit = cast_at_sphere(o, m, {}, std::get<Sphere>(*shape.geometry).radius);
            break;
        case ShapeKind::capsule:
            hit = cast_at_capsule(o, m, std::get<Capsule>(*shape.geometry));
            break;
        case ShapeKind::box:
            hit = cast_at_box(o, m, std::get<Box>(*shape.geometry).half_extents);
            break;
        case ShapeKind::plane:
            hit = cast_at_plane(o, m, std::get<Plane>(*shape.geometry).normal);
            break;
    }
    if (hit) hit->normal = shape.axes * hit->normal;
    return hit;
}

}  // namespace jostle::physics
