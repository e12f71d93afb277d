// SPDX-License-Identifier: MIT
#include "physics/src/world/checks.h"

#include "jostle/physics/limits.h"
#include "physics/src/foundation/messages.h"
#include "physics/src/geometry/outline.h"

namespace jostle::physics {

Status check_world(const WorldDef& def) {
    if (Status s = check_vector("gravity", def.gravity, 1e4); !s.ok()) return s;
    if (def.planar && def.gravity.z != 0)
        return invalid_argument("gravity.z is " + text(def.gravity.z) +
                                "; it must be 0 in a planar world");
    if (Status s = check_range("hit_speed", def.hit_speed, 0, 1e6); !s.ok()) return s;
    if (def.broad_phase > BroadPhase::uniform_grid)
        return invalid_argument("broad_phase is " +
                                std::to_string(static_cast<int>(def.broad_phase)) +
                                "; it must be from 0 to 2");
    if (def.tolerance != 0)
        if (Status s = check_range("tolerance", def.tolerance, 1e-9, 1e3); !s.ok()) return s;
    if (Status s =
            check_range("substep_budget", static_cast<double>(def.substep_budget), 0, 4294967295.0);
        !s.ok())
        return s;
    if (Status s =
            check_range("step_budget", static_cast<double>(def.step_budget), 0, 4294967295.0);
        !s.ok())
        return s;
    if (def.step_budget > 0 && def.tolerance > 0)
        return invalid_argument(
            "step_budget and tolerance are both set; sub-steps follow either the work of a step or "
            "its error: set one of them to 0 (substep_budget limits the cost of a tolerance)");
    if (Status s = check_range("max_pairs_per_shape", def.max_pairs_per_shape, 0,
                               limits::max_pairs_per_shape);
        !s.ok())
        return s;
    if (Status s = check_joint_solver("joint_solver", def.joint_solver); !s.ok()) return s;
    if (Status s = check_range("substeps", def.substeps, 1, limits::max_substeps); !s.ok())
        return s;
    return check_range("threads", def.threads, 1, limits::max_threads);
}

Status check_joint_solver(const char* name, JointSolver solver) {
    if (solver <= JointSolver::direct) return {};
    return invalid_argument(std::string(name) + " is " + std::to_string(static_cast<int>(solver)) +
                            "; it must be automatic (0), iterative (1) or direct (2)");
}

Status check_body(const BodyDef& def) {
    if (Status s = check_pose("pose", def.pose); !s.ok()) return s;
    if (Status s = check_vector("linear_velocity", def.linear_velocity, limits::max_speed); !s.ok())
        return s;
    if (Status s = check_vector("angular_velocity", def.angular_velocity, limits::max_speed);
        !s.ok())
        return s;
    if (Status s = check_range("linear_damping", def.linear_damping, 0, 1e4); !s.ok()) return s;
    if (Status s = check_range("angular_damping", def.angular_damping, 0, 1e4); !s.ok()) return s;
    if (Status s = check_range("gravity_scale", def.gravity_scale, -1e3, 1e3); !s.ok()) return s;
    if (Status s = check_mass(def.mass); !s.ok()) return s;
    if (Status s = check_body_type(def.type); !s.ok()) return s;
    if (def.locks >= 64)
        return invalid_argument("locks is " + std::to_string(def.locks) +
                                "; it must be from 0 to 63");
    const bool moves = !(def.linear_velocity == Vec3{}) || !(def.angular_velocity == Vec3{});
    if (def.type == BodyType::static_body && moves)
        return invalid_argument(
            "a static body cannot have a velocity; make it kinematic or remove the velocity");
    return {};
}

Status check_flat(const char* name, const Transform& pose) {
    if (pose.position.z != 0)
        return invalid_argument(std::string(name) + ".position.z is " + text(pose.position.z) +
                                "; it must be 0 in a planar world");
    if (pose.rotation.x != 0 || pose.rotation.y != 0)
        return invalid_argument(
            std::string(name) +
            ".rotation is not about z; bodies in a planar world rotate about z only");
    return {};
}

Status check_flat_body(const BodyDef& def) {
    if (Status s = check_flat("pose", def.pose); !s.ok()) return s;
    if (def.linear_velocity.z != 0 || def.angular_velocity.x != 0 || def.angular_velocity.y != 0)
        return invalid_argument(
            "linear_velocity.z, angular_velocity.x and angular_velocity.y must be 0 in a planar "
            "world");
    return {};
}

Status check_flat_shape(const ShapeDef& def) {
    const ShapeKind kind = kind_of(def.geometry);
    if (kind != ShapeKind::plane && !has_outline(kind))
        return invalid_argument(
            std::string("a ") + kind_name(kind) +
            " is not supported in a planar world; use spheres (discs), capsules, boxes, "
            "hulls and planes");
    if (kind == ShapeKind::plane && std::get<Plane>(def.geometry).normal.z != 0)
        return invalid_argument("the plane's normal.z must be 0 in a planar world");
    return check_flat("shape pose", def.pose);
}

Status check_shape(const ShapeDef& def, BodyType type) {
    if (Status s = check_geometry("geometry", def.geometry); !s.ok()) return s;
    if (Status s = check_pose("shape pose", def.pose); !s.ok()) return s;
    if (Status s = check_material(def.material); !s.ok()) return s;
    const ShapeKind kind = kind_of(def.geometry);
    if (kind == ShapeKind::plane && type != BodyType::static_body)
        return invalid_argument("a plane is infinite; only a static body can have one");
    const bool surface = kind == ShapeKind::mesh || kind == ShapeKind::height_field;
    if (surface && type == BodyType::dynamic)
        return invalid_argument(
            std::string("a ") + kind_name(kind) +
            " has no volume and no mass; use hulls or a compound for a dynamic body");
    if (surface && def.trigger)
        return invalid_argument(std::string("a ") + kind_name(kind) +
                                " has no volume; a trigger needs a solid shape");
    if (Status s = check_mass(def.mass); !s.ok()) return s;
    if (type != BodyType::dynamic || def.trigger || def.mass > 0)
        return check_range("density", def.density, 0, limits::max_density);
    if (!(def.density > 0))
        return invalid_argument("density is " + text(def.density) +
                                "; it must be above 0 for a dynamic body");
    return check_range("density", def.density, 1e-6, limits::max_density);
}

Status check_body_type(BodyType type) {
    if (type == BodyType::static_body || type == BodyType::kinematic || type == BodyType::dynamic)
        return {};
    return invalid_argument("type is " + std::to_string(static_cast<int>(type)) +
                            "; it must be static (0), kinematic (1) or dynamic (2)");
}

Status check_body_in(const WorldDef& world, const BodyDef& def) {
    if (Status s = check_body(def); !s.ok()) return s;
    return world.planar ? check_flat_body(def) : Status{};
}

Status check_shape_in(const WorldDef& world, const ShapeDef& def, BodyType type) {
    if (Status s = check_shape(def, type); !s.ok()) return s;
    return world.planar ? check_flat_shape(def) : Status{};
}

Status check_shapes_in(const WorldDef& world, std::span<const ShapeDef> defs, BodyType type) {
    for (std::size_t k = 0; k < defs.size(); k++)
        if (Status s = check_shape_in(world, defs[k], type); !s.ok()) {
            if (defs.size() == 1) return s;
            return Error{s.error().code, "shapes[" + std::to_string(k) + "]: " + s.error().message};
        }
    return {};
}

ShapeDef def_of(const ShapeRecord& shape) {
    return {.geometry = shape.geometry,
            .pose = shape.pose,
            .material = shape.material,
            .density = shape.density,
            .mass = shape.mass,
            .filter = shape.filter,
            .trigger = shape.trigger,
            .report_stays = shape.report_stays,
            .user_data = shape.user_data};
}

Status check_id(const BodyStore& bodies, BodyId id) {
    if (bodies.ids.matches(id.index, id.generation)) return {};
    return Error{ErrorCode::not_found, "no body has the id {" + std::to_string(id.index) + ", " +
                                           std::to_string(id.generation) +
                                           "}; it never existed or was destroyed"};
}

Status check_id(const ShapeStore& shapes, ShapeId id) {
    if (shapes.ids.matches(id.index, id.generation)) return {};
    return Error{ErrorCode::not_found, "no shape has the id {" + std::to_string(id.index) + ", " +
                                           std::to_string(id.generation) +
                                           "}; it never existed or was destroyed"};
}

Status check_id(const JointStore& joints, JointId id) {
    if (joints.ids.matches(id.index, id.generation)) return {};
    return Error{ErrorCode::not_found, "no joint has the id {" + std::to_string(id.index) + ", " +
                                           std::to_string(id.generation) +
                                           "}; it never existed, broke or was destroyed"};
}

Status check_id(const FieldStore& fields, FieldId id) {
    if (fields.ids.matches(id.index, id.generation)) return {};
    return Error{ErrorCode::not_found, "no force field has the id {" + std::to_string(id.index) +
                                           ", " + std::to_string(id.generation) +
                                           "}; it never existed or was destroyed"};
}

Status check_not_stepping(const ListenerStore& listeners, const char* action) {
    if (listeners.stepping == nullptr) return {};
    return Error{ErrorCode::failed_precondition,
                 std::string("cannot ") + action + " during a step"};
}

Geometry stored(const Geometry& geometry) {
    if (kind_of(geometry) != ShapeKind::plane) return geometry;
    return Plane{normalized(std::get<Plane>(geometry).normal)};
}

}  // namespace jostle::physics
