// SPDX-License-Identifier: MIT
#include "world/checks.h"

#include <cstdio>

#include "jostle/physics/tuning.h"

namespace jostle::physics {
namespace {

std::string text(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.9g", x);
    return buffer;
}
std::string text(Vec3 v) {
    return "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")";
}

Error invalid(std::string message) {
    return {ErrorCode::invalid_argument, std::move(message)};
}

Status check_size(const char* name, const char* field, double size) {
    return check_range((std::string(name) + "." + field).c_str(), size, min_shape_size,
                       max_shape_size);
}

}  // namespace

Status check_range(const char* name, double value, double low, double high) {
    if (low <= value && value <= high) return {};
    return invalid(std::string(name) + " is " + text(value) + "; it must be from " + text(low) +
                   " to " + text(high));
}

Status check_vector(const char* name, Vec3 value, double limit) {
    const Vec3 size = abs(value);
    if (size.x <= limit && size.y <= limit && size.z <= limit) return {};
    return invalid(std::string(name) + " is " + text(value) +
                   "; each component must be finite and at most " + text(limit) + " in size");
}

Status check_pose(const char* name, const Transform& pose) {
    const std::string prefix = name;
    if (Status s =
            check_vector((prefix + ".position").c_str(), pose.position, tuning::max_coordinate);
        !s.ok())
        return s;
    const double norm = norm_squared(pose.rotation);
    if (is_finite(norm) && norm > 1e-12 && norm < 1e12) return {};
    const Quat q = pose.rotation;
    return invalid(prefix + ".rotation is (" + text(q.x) + ", " + text(q.y) + ", " + text(q.z) +
                   ", " + text(q.w) + "); it must be finite and not zero");
}

Status check_world(const WorldDef& def) {
    if (Status s = check_vector("gravity", def.gravity, 1e4); !s.ok()) return s;
    if (Status s = check_range("substeps", def.substeps, 1, tuning::max_substeps); !s.ok())
        return s;
    return check_range("threads", def.threads, 1, tuning::max_threads);
}

Status check_body(const BodyDef& def) {
    if (Status s = check_pose("pose", def.pose); !s.ok()) return s;
    if (Status s = check_vector("linear_velocity", def.linear_velocity, tuning::max_speed); !s.ok())
        return s;
    if (Status s = check_vector("angular_velocity", def.angular_velocity, tuning::max_speed);
        !s.ok())
        return s;
    if (Status s = check_range("linear_damping", def.linear_damping, 0, 1e4); !s.ok()) return s;
    if (Status s = check_range("angular_damping", def.angular_damping, 0, 1e4); !s.ok()) return s;
    if (Status s = check_range("gravity_scale", def.gravity_scale, -1e3, 1e3); !s.ok()) return s;
    const bool moves = !(def.linear_velocity == Vec3{}) || !(def.angular_velocity == Vec3{});
    if (def.type == BodyType::fixed && moves)
        return invalid(
            "a fixed body has no velocity; make it kinematic, or leave the velocity out");
    return {};
}

Status check_geometry(const char* name, const Geometry& geometry) {
    switch (kind_of(geometry)) {
        case ShapeKind::sphere:
            return check_size(name, "radius", std::get<Sphere>(geometry).radius);
        case ShapeKind::capsule: {
            const Capsule& c = std::get<Capsule>(geometry);
            if (Status s = check_size(name, "radius", c.radius); !s.ok()) return s;
            return check_size(name, "half_length", c.half_length);
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
            return invalid(std::string(name) + ".normal is " + text(n) +
                           "; it must be finite and not zero");
        }
    }
    return invalid(std::string(name) + " is of no known kind");
}

Status check_shape(const ShapeDef& def, BodyType type) {
    if (Status s = check_geometry("geometry", def.geometry); !s.ok()) return s;
    if (Status s = check_pose("shape pose", def.pose); !s.ok()) return s;
    if (Status s = check_range("friction", def.material.friction, 0, 100); !s.ok()) return s;
    if (Status s = check_range("restitution", def.material.restitution, 0, 1); !s.ok()) return s;
    if (kind_of(def.geometry) == ShapeKind::plane && type != BodyType::fixed)
        return invalid("a plane is infinite; only a fixed body may carry one");
    if (type != BodyType::dynamic)
        return check_range("density", def.density, 0, tuning::max_density);
    if (!(def.density > 0))
        return invalid("density is " + text(def.density) +
                       "; a dynamic body needs a shape of density above 0 to have mass");
    return check_range("density", def.density, 1e-6, tuning::max_density);
}

Status check_id(const WorldState& world, BodyId id) {
    if (world.bodies.ids.matches(id.index, id.generation)) return {};
    return Error{ErrorCode::not_found, "no body has the id {" + std::to_string(id.index) + ", " +
                                           std::to_string(id.generation) +
                                           "}; it never existed or was destroyed"};
}

Status check_id(const WorldState& world, ShapeId id) {
    if (world.shapes.ids.matches(id.index, id.generation)) return {};
    return Error{ErrorCode::not_found, "no shape has the id {" + std::to_string(id.index) + ", " +
                                           std::to_string(id.generation) +
                                           "}; it never existed or was destroyed"};
}

Quat unit(Quat q) {
    return norm_squared(q) == 1 ? q : normalized(q);
}

Geometry stored(const Geometry& geometry) {
    if (kind_of(geometry) != ShapeKind::plane) return geometry;
    return Plane{normalized(std::get<Plane>(geometry).normal)};
}

}  // namespace jostle::physics
