// SPDX-License-Identifier: MIT
#include "physics/src/geometry/shape_measures.h"

#include "jostle/base/check.h"
#include "jostle/physics/compound.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"

namespace jostle::physics {
namespace {

// Extent of a disc with the normal `y` along each world axis.
Vec3 disc_reach(Vec3 y, double radius) {
    const auto across = [](double c) { return square_root(maximum(0, 1 - c * c)); };
    return Vec3{across(y.x), across(y.y), across(y.z)} * radius;
}

// Bounding box of a transformed local box. Not tight, but cheap for many points.
Aabb turned(const TransformedShape& shape, const Aabb& local) {
    const Vec3 middle = (local.low + local.high) * 0.5, half = (local.high - local.low) * 0.5;
    ASSERT(half.x >= 0 && half.y >= 0 && half.z >= 0);
    const Vec3 center = shape.position + shape.axes * middle;
    const Vec3 reach =
        abs(shape.axes.x) * half.x + abs(shape.axes.y) * half.y + abs(shape.axes.z) * half.z;
    return {center - reach, center + reach};
}

Aabb bounds_of_points(const TransformedShape& shape, const std::vector<Vec3>& points) {
    Aabb box{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
    ASSERT(!points.empty());
    for (const Vec3 p : points) {
        const Vec3 q = shape.axes * p;
        box = unite(box, {q, q});
    }
    return {shape.position + box.low, shape.position + box.high};
}

// Distance of the furthest corner of a box from the origin.
double furthest_corner(const Aabb& box) {
    return length(max(abs(box.low), abs(box.high)));
}

}  // namespace

Aabb bounds_of(const TransformedShape& shape) {
    Vec3 reach;
    ASSERT(shape.geometry != nullptr);
    switch (kind_of(*shape.geometry)) {
        case ShapeKind::sphere: {
            const double r = std::get<Sphere>(*shape.geometry).radius;
            reach = {r, r, r};
            break;
        }
        case ShapeKind::capsule: {
            const Capsule& c = std::get<Capsule>(*shape.geometry);
            reach = abs(shape.axes.y) * c.half_length + Vec3{c.radius, c.radius, c.radius};
            break;
        }
        case ShapeKind::box: {
            const Vec3 h = std::get<Box>(*shape.geometry).half_extents;
            reach = abs(shape.axes.x) * h.x + abs(shape.axes.y) * h.y + abs(shape.axes.z) * h.z;
            break;
        }
        case ShapeKind::cylinder: {
            const Cylinder& c = std::get<Cylinder>(*shape.geometry);
            reach = abs(shape.axes.y) * c.half_length + disc_reach(shape.axes.y, c.radius);
            break;
        }
        case ShapeKind::cone: {
            const Cone& c = std::get<Cone>(*shape.geometry);
            const Vec3 tip = shape.position + shape.axes.y * c.half_length;
            const Vec3 base = shape.position - shape.axes.y * c.half_length;
            const Vec3 disc = disc_reach(shape.axes.y, c.radius);
            return {min(tip, base - disc), max(tip, base + disc)};
        }
        case ShapeKind::hull:
            return bounds_of_points(shape, std::get<Hull>(*shape.geometry).data->vertices);
        case ShapeKind::mesh:
            return turned(shape, std::get<Mesh>(*shape.geometry).data->bounds);
        case ShapeKind::height_field:
            return turned(shape, std::get<HeightField>(*shape.geometry).data->bounds);
        case ShapeKind::compound:
            return turned(shape, std::get<Compound>(*shape.geometry).data->bounds);
        case ShapeKind::plane:
            ASSERT(false);
    }
    return {shape.position - reach, shape.position + reach};
}

double radius_of(const Geometry& geometry) {
    switch (kind_of(geometry)) {
        case ShapeKind::sphere:
            return std::get<Sphere>(geometry).radius;
        case ShapeKind::capsule: {
            const Capsule& c = std::get<Capsule>(geometry);
            return c.radius + c.half_length;
        }
        case ShapeKind::box:
            return length(std::get<Box>(geometry).half_extents);
        case ShapeKind::cylinder: {
            const Cylinder& c = std::get<Cylinder>(geometry);
            return length(Vec3{c.radius, c.half_length, 0});
        }
        case ShapeKind::cone: {
            const Cone& c = std::get<Cone>(geometry);
            return length(Vec3{c.radius, c.half_length, 0});
        }
        case ShapeKind::hull: {
            double furthest = 0;
            for (const Vec3 p : std::get<Hull>(geometry).data->vertices)
                furthest = maximum(furthest, length_squared(p));
            return square_root(furthest);
        }
        case ShapeKind::mesh:
            return furthest_corner(std::get<Mesh>(geometry).data->bounds);
        case ShapeKind::height_field:
            return furthest_corner(std::get<HeightField>(geometry).data->bounds);
        case ShapeKind::compound:
            return furthest_corner(std::get<Compound>(geometry).data->bounds);
        case ShapeKind::plane:
            ASSERT(false);
    }
    return 0;
}

Aabb bounds_in(const TransformedShape& frame, const TransformedShape& shape) {
    const TransformedShape local{shape.geometry,
                                 transposed_times(frame.axes, shape.position - frame.position),
                                 transpose(frame.axes) * shape.axes};
    return bounds_of(local);
}

}  // namespace jostle::physics
