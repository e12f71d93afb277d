// SPDX-License-Identifier: MIT
//
// Motion of bodies: poses, velocities, forces and impulses.
#include "jostle/base/check.h"
#include "jostle/physics/limits.h"
#include "jostle/physics/world.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/shape_proxy.h"
#include "physics/src/state/wake.h"
#include "physics/src/world/body_change.h"
#include "physics/src/world/checks.h"

namespace jostle::physics {

Status World::set_pose(BodyId body, const Transform& pose) {
    WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s;
    if (Status s = check_pose("pose", pose); !s.ok()) return s;
    if (world.def.planar)
        if (Status s = check_flat("pose", pose); !s.ok()) return s;
    wake_neighbours(world, body.index);
    BodyWarm& warm = wake_to_change(world, body.index);
    // A teleport, not a motion: the contacts at the old pose do not apply at the new one.
    destroy_contacts_of(world, body.index, world.events.pending.ended);
    ASSERT(warm.body == body.index);
    warm.rotation = unit(pose.rotation);
    warm.axes = to_matrix(warm.rotation);
    warm.center = pose.position + warm.axes * world.bodies.cold[body.index].local_center;
    if (world.bodies.cold[body.index].type == BodyType::static_body) world.static_revision++;
    after_move(world, body.index);
    return {};
}

Status World::set_velocity(BodyId body, Vec3 linear, Vec3 angular) {
    WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s;
    if (Status s = check_vector("linear", linear, limits::max_speed); !s.ok()) return s;
    if (Status s = check_vector("angular", angular, limits::max_speed); !s.ok()) return s;
    if (world.bodies.cold[body.index].type == BodyType::static_body)
        return Error{ErrorCode::failed_precondition,
                     "a static body cannot have a velocity; use a kinematic body"};
    // A platform that starts to move carries the bodies that rest on it.
    if (world.bodies.cold[body.index].type == BodyType::kinematic)
        wake_neighbours(world, body.index);
    BodyWarm& warm = wake_to_change(world, body.index);
    warm.v = linear;
    warm.w = angular;
    obey_locks(world.bodies.cold[body.index], warm);
    after_push(world, body.index);
    return {};
}

Status World::set_linear_velocity(BodyId body, Vec3 velocity) {
    if (Status s = check_id(state_->bodies, body); !s.ok()) return s;
    return set_velocity(body, velocity, warm_of(*state_, body.index).w);
}

Status World::set_angular_velocity(BodyId body, Vec3 velocity) {
    if (Status s = check_id(state_->bodies, body); !s.ok()) return s;
    return set_velocity(body, warm_of(*state_, body.index).v, velocity);
}

Status World::move_to(BodyId body, const Transform& pose, double dt) {
    WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s;
    if (Status s = check_pose("pose", pose); !s.ok()) return s;
    if (Status s = check_range("dt", dt, 1e-5, 0.25); !s.ok()) return s;
    const BodyCold& cold = world.bodies.cold[body.index];
    if (cold.type != BodyType::kinematic)
        return Error{ErrorCode::failed_precondition,
                     "body {" + std::to_string(body.index) + ", " +
                         std::to_string(body.generation) +
                         "} is not kinematic; move_to() requires a kinematic body"};
    const BodyWarm& warm = warm_of(world, body.index);
    const Quat q = unit(pose.rotation) * conjugate(warm.rotation);
    const Vec3 axis{q.x, q.y, q.z};
    const double l = length(axis), sign = q.w < 0 ? -1 : 1;  // the shorter rotation
    ASSERT(l <= 1 + 1e-9);
    const Vec3 turn = l > 1e-15 ? axis * (2 * sign * arc_tangent(l, q.w * sign) / l) : Vec3{};
    const Vec3 displacement =
        pose.position - warm.center;  // kinematic bodies rotate about their origin
    return set_velocity(body, displacement * (1 / dt), turn * (1 / dt));
}

Status World::apply_impulse(BodyId body, Vec3 impulse, Vec3 point) {
    WorldState& world = *state_;
    if (Status s = check_dynamic(world.bodies, body); !s.ok()) return s;
    if (Status s = check_vector("impulse", impulse, 1e12); !s.ok()) return s;
    if (Status s = check_vector("point", point, limits::max_coordinate); !s.ok()) return s;
    const BodyCold& cold = world.bodies.cold[body.index];
    BodyWarm& warm = wake_to_change(world, body.index);
    warm.v += scaled(impulse, free_directions(cold)) * cold.inverse_mass;
    warm.w += world_inverse_inertia(warm, cold) * cross(point - warm.center, impulse);
    after_push(world, body.index);
    return {};
}

Status World::apply_angular_impulse(BodyId body, Vec3 impulse) {
    WorldState& world = *state_;
    if (Status s = check_dynamic(world.bodies, body); !s.ok()) return s;
    if (Status s = check_vector("impulse", impulse, 1e12); !s.ok()) return s;
    BodyWarm& warm = wake_to_change(world, body.index);
    warm.w += world_inverse_inertia(warm, world.bodies.cold[body.index]) * impulse;
    after_push(world, body.index);
    return {};
}

Status World::apply_force(BodyId body, Vec3 force, Vec3 point) {
    WorldState& world = *state_;
    if (Status s = check_dynamic(world.bodies, body); !s.ok()) return s;
    if (Status s = check_vector("force", force, 1e12); !s.ok()) return s;
    if (Status s = check_vector("point", point, limits::max_coordinate); !s.ok()) return s;
    BodyWarm& warm = wake_to_change(world, body.index);
    warm.force += force;
    warm.torque += cross(point - warm.center, force);
    update_motion_bound(world, body.index, expected_dt(world));
    return {};
}

Status World::apply_torque(BodyId body, Vec3 torque) {
    WorldState& world = *state_;
    if (Status s = check_dynamic(world.bodies, body); !s.ok()) return s;
    if (Status s = check_vector("torque", torque, 1e12); !s.ok()) return s;
    wake_to_change(world, body.index).torque += torque;
    return {};
}

}  // namespace jostle::physics
