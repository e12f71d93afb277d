// SPDX-License-Identifier: MIT
//
// Changes of body properties: type, mass, locks, damping, sleep.
#include <string>

#include "jostle/base/check.h"
#include "jostle/physics/world.h"
#include "physics/src/state/body_sets.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/island_sleep.h"
#include "physics/src/state/islands.h"
#include "physics/src/state/joint_graph.h"
#include "physics/src/state/partial_sleep.h"
#include "physics/src/state/shape_proxy.h"
#include "physics/src/state/wake.h"
#include "physics/src/world/body_change.h"
#include "physics/src/world/checks.h"
#include "physics/src/world/mass.h"

namespace jostle::physics {
namespace {

// Checks whether the shapes and joints of a body allow the type.
Status check_type(const WorldState& world, std::uint32_t body, BodyType type) {
    const BodyCold& cold = world.bodies.cold[body];
    for (std::uint32_t s = cold.first_shape; s != none; s = world.shapes.shapes[s].next)
        if (Status status = check_shape(def_of(world.shapes.shapes[s]), type); !status.ok())
            return status;
    if (type == BodyType::dynamic && cold.first_shape == none)
        return Error{ErrorCode::failed_precondition,
                     "a dynamic body needs a shape for its mass; create a shape first"};
    Status joints;
    for_each_joint(world.joints, cold, [&](std::uint32_t index) {
        const Joint& joint = world.joints.joints[index];
        const std::uint32_t other = joint.body_a == body ? joint.body_b : joint.body_a;
        if (type != BodyType::dynamic && !is_dynamic(world.bodies, other))
            joints = Error{ErrorCode::failed_precondition,
                           "joint {" + std::to_string(index) + ", " +
                               std::to_string(world.joints.ids.generation(index)) +
                               "} would connect two bodies that are not dynamic; destroy it first"};
    });
    return joints;
}

// Moves the body from the tree, island and set of its old type to those of the new type.
void change_type(WorldState& world, std::uint32_t body, BodyType type) {
    BodyCold& cold = world.bodies.cold[body];
    for (std::uint32_t s = cold.first_shape; s != none; s = world.shapes.shapes[s].next)
        destroy_proxy(world, s, world.events.pending.left);
    if (cold.island != none) {
        world.islands.islands[cold.island].may_be_split = true;
        remove_from_island(world, body);
    }
    BodyWarm warm = warm_of(world, body);
    ASSERT(warm.body == body && cold.first_edge == none);
    leave_set(world, body);
    cold.type = type;
    warm.force = warm.torque = {};
    warm.sleep_time = 0;
    if (type == BodyType::static_body) {
        warm.v = warm.w = {};
        enter_static(world.bodies, warm);
    } else {
        enter_awake(world.bodies, warm);
    }
    if (type == BodyType::dynamic)
        add_to_island(world, create_island(world.islands, world.def), body);
    update_mass(world, world.def, body);
    ASSERT((type == BodyType::dynamic) == (cold.island != none));
    obey_locks(cold, warm_of(world, body));
    after_move(world, body);
    for (std::uint32_t s = cold.first_shape; s != none; s = world.shapes.shapes[s].next)
        create_proxy(world, s);
    if (type != BodyType::dynamic) return;
    for_each_joint(world.joints, cold, [&](std::uint32_t index) {
        const Joint& joint = world.joints.joints[index];
        if (is_dynamic(world.bodies, joint.body_a) && is_dynamic(world.bodies, joint.body_b))
            join_islands(world, world.joints, world.bodies.cold[joint.body_a].island,
                         world.bodies.cold[joint.body_b].island);
    });
}

}  // namespace

Status World::set_type(BodyId body, BodyType type) {
    WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s;
    if (Status s = check_body_type(type); !s.ok()) return s;
    if (world.bodies.cold[body.index].type == type) return {};
    if (Status s = check_type(world, body.index, type); !s.ok()) return s;
    wake_neighbours(world, body.index);
    wake_body(world, body.index);
    destroy_contacts_of(world, body.index, world.events.pending.ended);
    change_type(world, body.index, type);
    return {};
}

Status World::set_mass(BodyId body, double mass) {
    WorldState& world = *state_;
    if (Status s = check_dynamic(world.bodies, body); !s.ok()) return s;
    if (Status s = check_mass(mass); !s.ok()) return s;
    wake_neighbours(world, body.index);
    wake_body(world, body.index);
    // Manifolds store effective masses and must be rebuilt.
    destroy_contacts_of(world, body.index, world.events.pending.ended);
    world.bodies.cold[body.index].mass_override = mass;
    update_mass(world, world.def, body.index);
    after_move(world, body.index);
    return {};
}

Status World::set_sleep_allowed(BodyId body, bool allowed) {
    WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s;
    if (!allowed) wake_body(world, body.index);
    world.bodies.cold[body.index].sleep_allowed = allowed;
    return {};
}

Status World::set_awake(BodyId body, bool awake) {
    WorldState& world = *state_;
    if (awake) return wake(body);
    if (Status s = check_dynamic(world.bodies, body); !s.ok()) return s;
    if (!world.def.sleeping)
        return Error{ErrorCode::failed_precondition,
                     "sleeping is disabled in this world (WorldDef::sleeping is false)"};
    const std::uint32_t first = world.bodies.cold[body.index].island;
    ASSERT(world.islands.ids.alive(first));
    if (world.islands.islands[first].asleep) return {};
    if (world.islands.islands[first].may_be_split) split_island(world, first);
    const std::uint32_t island = world.bodies.cold[body.index].island;
    for (std::uint32_t b = world.islands.islands[island].first; b != none;
         b = world.bodies.cold[b].island_next) {
        if (!world.bodies.cold[b].asleep_in_place)
            world.events.pending.fell_asleep.push_back(body_id(world.bodies, b));
        wake_in_place(world, b);
    }
    put_island_to_sleep(world, island, world.events.pending.ended);
    ASSERT(world.bodies.cold[body.index].set == BodySet::sleeping);
    world.static_revision++;  // the body may have been woken and moved before
    return {};
}

Status World::set_user_data(BodyId body, std::uint64_t data) {
    if (Status s = check_id(state_->bodies, body); !s.ok()) return s;
    state_->bodies.cold[body.index].user_data = data;
    return {};
}

Status World::set_damping(BodyId body, double linear, double angular) {
    WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s;
    if (Status s = check_range("linear", linear, 0, 1e4); !s.ok()) return s;
    if (Status s = check_range("angular", angular, 0, 1e4); !s.ok()) return s;
    wake_body(world, body.index);
    world.bodies.cold[body.index].linear_damping = linear;
    world.bodies.cold[body.index].angular_damping = angular;
    return {};
}

Status World::set_gravity_scale(BodyId body, double scale) {
    WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s;
    if (Status s = check_range("scale", scale, -1e3, 1e3); !s.ok()) return s;
    wake_body(world, body.index);
    world.bodies.cold[body.index].gravity_scale = scale;
    update_motion_bound(world, body.index, expected_dt(world));
    return {};
}

Status World::set_locks(BodyId body, AxisLocks locks) {
    WorldState& world = *state_;
    if (Status s = check_id(world.bodies, body); !s.ok()) return s;
    if (locks >= 64)
        return Error{ErrorCode::invalid_argument,
                     "locks is " + std::to_string(locks) + "; it must be from 0 to 63"};
    wake_neighbours(world, body.index);
    BodyWarm& warm = wake_to_change(world, body.index);
    destroy_contacts_of(world, body.index, world.events.pending.ended);
    world.bodies.cold[body.index].locks = static_cast<AxisLocks>(
        locks | (world.def.planar ? lock_z | lock_rotation_x | lock_rotation_y : 0));
    obey_locks(world.bodies.cold[body.index], warm);
    update_mass(world, world.def, body.index);
    after_move(world, body.index);
    return {};
}

Status World::wake(BodyId body) {
    if (Status s = check_id(state_->bodies, body); !s.ok()) return s;
    wake_body(*state_, body.index);
    return {};
}

}  // namespace jostle::physics
