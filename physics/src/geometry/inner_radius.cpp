// SPDX-License-Identifier: MIT
#include "physics/src/geometry/shape_measures.h"

#include "jostle/physics/compound.h"
#include "jostle/physics/hull.h"

namespace jostle::physics {

double inner_radius_of(const Geometry& geometry) {
    switch (kind_of(geometry)) {
        case ShapeKind::sphere:
            return std::get<Sphere>(geometry).radius;
        case ShapeKind::capsule:
            return std::get<Capsule>(geometry).radius;
        case ShapeKind::box: {
            const Vec3 h = std::get<Box>(geometry).half_extents;
            return minimum(h.x, minimum(h.y, h.z));
        }
        case ShapeKind::cylinder: {
            const Cylinder& c = std::get<Cylinder>(geometry);
            return minimum(c.radius, c.half_length);
        }
        case ShapeKind::cone: {
            // Inscribed ball touching base and side: r h / (r + sqrt(r^2 + h^2)).
            const Cone& c = std::get<Cone>(geometry);
            const double h = 2 * c.half_length;
            return c.radius * h / (c.radius + square_root(c.radius * c.radius + h * h));
        }
        case ShapeKind::hull:
            return std::get<Hull>(geometry).data->inner_radius;
        case ShapeKind::compound:
            return std::get<Compound>(geometry).data->inner_radius;
        case ShapeKind::plane:
            return 1e300;
        case ShapeKind::mesh:
        case ShapeKind::height_field:
            break;
    }
    return 0;
}

}  // namespace jostle::physics
