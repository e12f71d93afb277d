// SPDX-License-Identifier: MIT
//
// Each kind is solved in the shape's local frame with the ray o + t m, 0 <= t <= 1.
#include "physics/src/geometry/ray.h"

#include "jostle/base/check.h"
#include "jostle/physics/compound.h"
#include "jostle/physics/hull.h"
#include "physics/src/geometry/surface.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

using Hit = std::optional<ShapeRayHit>;

Hit from_inside(Vec3 motion) {
    return ShapeRayHit{0, normalized(-motion)};
}

// The smaller root of |o + t m - c|^2 = r^2, for an origin outside.
Hit cast_at_sphere(Vec3 o, Vec3 m, Vec3 center, double radius) {
    const Vec3 d = o - center;
    const double a = dot(m, m), b = dot(d, m), c = dot(d, d) - radius * radius;
    if (c <= 0) return from_inside(m);
    const double discriminant = b * b - a * c;
    if (b >= 0 || discriminant < 0) return {};
    // c / (-b + sqrt) instead of (-b - sqrt) / a: no cancellation for far origins.
    const double t = c / (-b + square_root(discriminant));
    ASSERT(t >= 0);
    if (t > 1) return {};
    return ShapeRayHit{t, normalized(d + m * t)};
}

Hit cast_at_capsule(Vec3 o, Vec3 m, const Capsule& capsule) {
    const double h = capsule.half_length, r = capsule.radius;
    const Vec3 nearest{0, clamp(o.y, -h, h), 0};
    if (length_squared(o - nearest) <= r * r) return from_inside(m);
    Hit best;
    // The side: a circle in the xz plane, if the ray hits it between the two ends.
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
    ASSERT(enter <= 1);
    return ShapeRayHit{enter, normal};
}

Hit cast_at_plane(Vec3 o, Vec3 m, Vec3 normal) {
    const double height = dot(o, normal), climb = dot(m, normal);
    ASSERT(is_unit(normal));
    if (height <= 0) return from_inside(m);
    if (climb >= 0 || height > -climb) return {};
    return ShapeRayHit{height / -climb, normal};
}

// The interval of the line inside the slab |y| <= h.
struct Stretch {
    double enter, leave;
    double side;  // y component of the normal at the entry
};
Stretch between_ends(Vec3 o, Vec3 m, double h) {
    if (m.y == 0) return absolute(o.y) <= h ? Stretch{-1e300, 1e300, 0} : Stretch{1, -1, 0};
    const double t1 = (-h - o.y) / m.y, t2 = (h - o.y) / m.y;
    return {minimum(t1, t2), maximum(t1, t2), m.y > 0 ? -1.0 : 1.0};
}

Hit cast_at_cylinder(Vec3 o, Vec3 m, const Cylinder& cylinder) {
    const double r = cylinder.radius;
    const double a = m.x * m.x + m.z * m.z, b = o.x * m.x + o.z * m.z;
    const double c = o.x * o.x + o.z * o.z - r * r;
    const Stretch slab = between_ends(o, m, cylinder.half_length);
    double enter = -1e300, leave = 1e300;
    if (a == 0) {
        if (c > 0) return {};
    } else {
        const double discriminant = b * b - a * c;
        if (discriminant < 0) return {};
        const double root = square_root(discriminant);
        // Avoid cancellation: one root from the sum, the other from the product.
        const double q = b > 0 ? -b - root : -b + root;
        const double t1 = q / a, t2 = q != 0 ? c / q : t1;
        enter = minimum(t1, t2);
        leave = maximum(t1, t2);
    }
    const double t = maximum(enter, slab.enter);
    if (t > minimum(leave, slab.leave) || t > 1 || minimum(leave, slab.leave) < 0) return {};
    if (t < 0) return from_inside(m);
    if (slab.enter > enter) return ShapeRayHit{t, {0, slab.side, 0}};
    return ShapeRayHit{t, normalized(Vec3{o.x + t * m.x, 0, o.z + t * m.z})};
}

// The side is x^2 + z^2 = k^2 (h - y)^2 with k = r / (2 h). The line intersects the double cone at
// most twice; only points between base and apex count.
Hit cast_at_cone(Vec3 o, Vec3 m, const Cone& cone) {
    const double h = cone.half_length, k = cone.radius / (2 * h), down = h - o.y;
    const double a = m.x * m.x + m.z * m.z - k * k * m.y * m.y;
    const double b = o.x * m.x + o.z * m.z + k * k * down * m.y;
    const double c = o.x * o.x + o.z * o.z - k * k * down * down;
    if (absolute(o.y) <= h && c <= 0) return from_inside(m);
    Hit best;
    const auto consider = [&](double t) {
        const double y = o.y + t * m.y;
        if (!(t >= 0 && t <= 1) || absolute(y) > h || (best && best->fraction <= t)) return;
        const Vec3 out{o.x + t * m.x, 0, o.z + t * m.z};
        const double l = length(out);
        best = ShapeRayHit{t, normalized(Vec3{out.x, l * k, out.z})};
    };
    const double discriminant = b * b - a * c;
    if (discriminant >= 0) {
        const double root = square_root(discriminant), q = b > 0 ? -b - root : -b + root;
        if (a != 0) consider(q / a);
        if (q != 0) consider(c / q);
    }
    if (m.y > 0 && o.y < -h) {
        const double t = (-h - o.y) / m.y, x = o.x + t * m.x, z = o.z + t * m.z;
        if (t <= 1 && x * x + z * z <= cone.radius * cone.radius && (!best || t < best->fraction))
            best = ShapeRayHit{t, {0, -1, 0}};
    }
    return best;
}

// Clips the ray against the planes of all faces.
Hit cast_at_hull(Vec3 o, Vec3 m, const ConvexHull& hull) {
    double enter = -1e300, leave = 1;
    const HullFace* entered = nullptr;
    for (const HullFace& face : hull.faces) {
        const double height = dot(face.normal, o) - face.offset, climb = dot(face.normal, m);
        if (climb == 0) {
            if (height > 0) return {};
            continue;
        }
        const double t = -height / climb;
        if (climb < 0) {
            if (t > enter) {
                enter = t;
                entered = &face;
            }
        } else {
            leave = minimum(leave, t);
        }
    }
    if (enter > leave || leave < 0) return {};
    if (enter < 0 || entered == nullptr) return from_inside(m);
    return ShapeRayHit{enter, entered->normal};
}

Hit cast_at_surface(Vec3 o, Vec3 m, const Geometry& surface) {
    Hit best;
    const auto consider = [&](const SurfaceTriangle& t, double limit) {
        const Hit hit = cast_at_triangle(o, m, t.corner);
        if (!hit || hit->fraction > limit || (best && best->fraction <= hit->fraction))
            return limit;
        best = hit;
        return hit->fraction;
    };
    if (const auto* mesh = std::get_if<Mesh>(&surface)) {
        mesh->data->tree->cast_ray(o, m, 1, [&](std::uint32_t index, double limit) {
            return consider(triangle_of(*mesh->data, index), limit);
        });
        return best;
    }
    // Traverse column by column along the ray's larger horizontal component, so that a long ray
    // tests only the cells below it.
    const HeightGrid& grid = *std::get<HeightField>(surface).data;
    const double start = ray_enters(grow(grid.bounds, 1e-9), o, m, 1);
    if (start > 1) return {};
    const int along = absolute(m.x) >= absolute(m.z) ? 0 : 2;
    const double spacing = along == 0 ? grid.spacing_x : grid.spacing_z;
    const double extent = absolute(m[along]);
    const double step = extent > 0 ? minimum(1, spacing / extent) : 1;
    ASSERT(step > 0 && start >= 0);
    for (double from = start; from < 1 && !(best && best->fraction < from); from += step) {
        const Vec3 p = o + m * from, q = o + m * minimum(1, from + step);
        for_each_triangle(grid, grow({min(p, q), max(p, q)}, 1e-9 * (1 + length(p))),
                          [&](const SurfaceTriangle& t) { consider(t, 1); });
    }
    return best;
}

Hit cast_at_compound(Vec3 o, Vec3 m, const CompoundShape& compound) {
    Hit best;
    compound.tree->cast_ray(o, m, 1, [&](std::uint32_t index, double limit) {
        const CompoundChild& child = compound.children[index];
        const Hit hit = cast_ray(transformed_shape(child.geometry, child.pose), o, m);
        if (!hit || (best && best->fraction <= hit->fraction)) return limit;
        best = hit;
        return minimum(limit, hit->fraction);
    });
    return best;
}

}  // namespace

std::optional<ShapeRayHit> cast_at_triangle(Vec3 o, Vec3 m, const Vec3 corner[3]) {
    const Vec3 u = corner[1] - corner[0], v = corner[2] - corner[0], p = cross(m, v);
    const double det = dot(u, p);
    if (det == 0) return {};
    const double scale = 1 / det;
    const Vec3 s = o - corner[0];
    // Extend the triangle slightly beyond its edges, so that no ray passes between two triangles.
    constexpr double slack = 1e-12;
    const double a = dot(s, p) * scale;
    if (a < -slack || a > 1 + slack) return {};
    const Vec3 q = cross(s, u);
    const double b = dot(m, q) * scale;
    if (b < -slack || a + b > 1 + slack) return {};
    const double t = dot(v, q) * scale;
    if (t < 0 || t > 1) return {};
    const Vec3 n = normalized(cross(u, v));
    ASSERT(is_unit(n));
    return ShapeRayHit{t, dot(n, m) > 0 ? -n : n};
}

std::optional<ShapeRayHit> cast_ray(const TransformedShape& shape, Vec3 origin, Vec3 motion) {
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
        case ShapeKind::cylinder:
            hit = cast_at_cylinder(o, m, std::get<Cylinder>(*shape.geometry));
            break;
        case ShapeKind::cone:
            hit = cast_at_cone(o, m, std::get<Cone>(*shape.geometry));
            break;
        case ShapeKind::hull:
            hit = cast_at_hull(o, m, *std::get<Hull>(*shape.geometry).data);
            break;
        case ShapeKind::mesh:
        case ShapeKind::height_field:
            hit = cast_at_surface(o, m, *shape.geometry);
            break;
        case ShapeKind::compound:
            hit = cast_at_compound(o, m, *std::get<Compound>(*shape.geometry).data);
            break;
    }
    if (hit) hit->normal = shape.axes * hit->normal;
    ASSERT(!hit || (hit->fraction >= 0 && hit->fraction <= 1));
    return hit;
}

}  // namespace jostle::physics
