// SPDX-License-Identifier: MIT
#include "physics/src/geometry/support.h"

#include "jostle/base/check.h"
#include "physics/src/geometry/hull_lanes.h"

namespace jostle::physics {
namespace {

// d < 0 ? -h : h without a branch, which would be unpredictable. h is not negative.
double signed_size(double d, double h) {
    return __builtin_copysign(h, d + 0.0);  // -0 + 0 is 0
}

// The point of the disc |p| = r in the xz plane along d; its centre if d is vertical.
Vec3 on_disc(Vec3 d, double r) {
    ASSERT(r >= 0);
    const double l2 = d.x * d.x + d.z * d.z;
    if (l2 < 1e-300) return {};
    const double s = r / square_root(l2);
    return {d.x * s, 0, d.z * s};
}

Vec3 local_support(const Convex& s, Vec3 d) {
    switch (s.core) {
        case Core::point:
            return {};
        case Core::segment:
            return {0, signed_size(d.y, s.size.y), 0};
        case Core::box:
            return {signed_size(d.x, s.size.x), signed_size(d.y, s.size.y),
                    signed_size(d.z, s.size.z)};
        case Core::cylinder: {
            Vec3 p = on_disc(d, s.size.x);
            p.y = signed_size(d.y, s.size.y);
            return p;
        }
        case Core::cone: {
            Vec3 rim = on_disc(d, s.size.x);
            rim.y = -s.size.y;
            return dot(rim, d) > s.size.y * d.y ? rim : Vec3{0, s.size.y, 0};
        }
        case Core::hull:
            return s.hull->vertices[furthest_vertex(*s.hull->lanes, d)];
        case Core::triangle: {
            const double a = dot(s.corner[0], d), b = dot(s.corner[1], d), c = dot(s.corner[2], d);
            if (a >= b && a >= c) return s.corner[0];
            return b >= c ? s.corner[1] : s.corner[2];
        }
    }
    return {};
}

}  // namespace

Convex convex_of(const TransformedShape& shape, Vec3 origin) {
    Convex c{.position = shape.position - origin, .axes = shape.axes, .size = {}};
    ASSERT(is_convex(kind_of(*shape.geometry)));
    switch (kind_of(*shape.geometry)) {
        case ShapeKind::sphere:
            c.radius = std::get<Sphere>(*shape.geometry).radius;
            break;
        case ShapeKind::capsule: {
            const Capsule& capsule = std::get<Capsule>(*shape.geometry);
            c.core = Core::segment;
            c.radius = capsule.radius;
            c.size.y = capsule.half_length;
            break;
        }
        case ShapeKind::box:
            c.core = Core::box;
            c.size = std::get<Box>(*shape.geometry).half_extents;
            break;
        case ShapeKind::cylinder: {
            const Cylinder& cylinder = std::get<Cylinder>(*shape.geometry);
            c.core = Core::cylinder;
            c.size = {cylinder.radius, cylinder.half_length, 0};
            break;
        }
        case ShapeKind::cone: {
            const Cone& cone = std::get<Cone>(*shape.geometry);
            c.core = Core::cone;
            c.size = {cone.radius, cone.half_length, 0};
            break;
        }
        case ShapeKind::hull:
            c.core = Core::hull;
            c.hull = std::get<Hull>(*shape.geometry).data.get();
            break;
        default:
            ASSERT(false);
    }
    return c;
}

Convex triangle_convex(const Vec3 corner[3], Vec3 position, const Mat3& axes) {
    return {
        .core = Core::triangle, .position = position, .axes = axes, .size = {}, .corner = corner};
}

Vec3 support(const Convex& shape, Vec3 d) {
    return shape.position + shape.axes * local_support(shape, transposed_times(shape.axes, d));
}

Vec3 middle_of(const Convex& shape) {
    Vec3 local;
    if (shape.core == Core::hull) local = shape.hull->center;
    if (shape.core == Core::cone) local = {0, -0.5 * shape.size.y, 0};
    if (shape.core == Core::triangle)
        local = (shape.corner[0] + shape.corner[1] + shape.corner[2]) * (1.0 / 3);
    return shape.position + shape.axes * local;
}

double size_of(const Convex& shape) {
    switch (shape.core) {
        case Core::hull:
            return length(shape.hull->bounds.high - shape.hull->bounds.low) * 0.5;
        case Core::triangle:
            return maximum(length(shape.corner[1] - shape.corner[0]),
                           length(shape.corner[2] - shape.corner[0]));
        default:
            return length(shape.size) + shape.radius;
    }
}

}  // namespace jostle::physics
