// SPDX-License-Identifier: MIT
#include "physics/src/geometry/geometry_checks.h"

#include "jostle/physics/compound.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"
#include "physics/src/foundation/messages.h"

namespace jostle::physics {
namespace {

Status check_size(const char* name, const char* field, double size) {
    if (min_shape_size <= size && size <= max_shape_size) return {};
    return check_range((std::string(name) + "." + field).c_str(), size, min_shape_size,
                       max_shape_size);
}

Status check_round(const char* name, double radius, double half_length) {
    if (Status s = check_size(name, "radius", radius); !s.ok()) return s;
    return check_size(name, "half_length", half_length);
}

Status check_data(const char* name, bool given, const char* builder) {
    if (given) return {};
    return invalid_argument(std::string(name) + " has no data; create it with " + builder);
}

}  // namespace

Status check_range(const char* name, double value, double low, double high) {
    if (low <= value && value <= high) return {};
    return invalid_argument(std::string(name) + " is " + text(value) + "; it must be from " +
                            text(low) + " to " + text(high));
}

Status check_geometry(const char* name, const Geometry& geometry) {
    switch (kind_of(geometry)) {
        case ShapeKind::sphere:
            return check_size(name, "radius", std::get<Sphere>(geometry).radius);
        case ShapeKind::capsule: {
            const Capsule& c = std::get<Capsule>(geometry);
            return check_round(name, c.radius, c.half_length);
        }
        case ShapeKind::box: {
            const Vec3 h = std::get<Box>(geometry).half_extents;
            if (Status s = check_size(name, "half_extents.x", h.x); !s.ok()) return s;
            if (Status s = check_size(name, "half_extents.y", h.y); !s.ok()) return s;
            return check_size(name, "half_extents.z", h.z);
        }
        case ShapeKind::plane: {
            const Vec3 n = std::get<Plane>(geometry).normal;
            const double l2 = length_squared(n);
            if (is_finite(l2) && l2 > 1e-12 && l2 < 1e12) return {};
            return invalid_argument(std::string(name) + ".normal is (" + text(n.x) + ", " +
                                    text(n.y) + ", " + text(n.z) +
                                    "); it must be finite and not zero");
        }
        case ShapeKind::cylinder: {
            const Cylinder& c = std::get<Cylinder>(geometry);
            return check_round(name, c.radius, c.half_length);
        }
        case ShapeKind::cone: {
            const Cone& c = std::get<Cone>(geometry);
            return check_round(name, c.radius, c.half_length);
        }
        case ShapeKind::hull: {
            // A hull without lanes was not created by build_hull.
            const auto& data = std::get<Hull>(geometry).data;
            return check_data(name, data != nullptr && data->lanes != nullptr, "build_hull");
        }
        case ShapeKind::mesh:
            return check_data(name, std::get<Mesh>(geometry).data != nullptr, "build_mesh");
        case ShapeKind::height_field:
            return check_data(name, std::get<HeightField>(geometry).data != nullptr,
                              "build_height_field");
        case ShapeKind::compound:
            return check_data(name, std::get<Compound>(geometry).data != nullptr, "build_compound");
    }
    return invalid_argument(std::string(name) + " has an unknown kind");
}

Status check_vector(const char* name, Vec3 value, double limit) {
    if (is_within(value, limit)) return {};
    return invalid_argument(std::string(name) + " is (" + text(value.x) + ", " + text(value.y) +
                            ", " + text(value.z) + "); each component must be finite and at most " +
                            text(limit) + " in size");
}

}  // namespace jostle::physics
