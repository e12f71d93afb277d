// SPDX-License-Identifier: MIT
#include "geometry/bounds.h"

#include "foundation/check.h"

namespace jostle::physics {

Aabb bounds_of(const Placed& shape) {
    Vec3 reach;
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
        case ShapeKind::plane:
            ASSERT(false);
    }
    return 0;
}

}  // namespace jostle::physics
