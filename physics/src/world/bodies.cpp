// SPDX-License-Identifier: MIT
//
// Creation, destruction and reading of bodies.
#include <algorithm>
#include <string>

#include "jostle/base/check.h"
#include "jostle/physics/world.h"
#include "physics/src/state/body_sets.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/islands.h"
#include "physics/src/state/joint_graph.h"
#include "physics/src/state/shape_proxy.h"
#include "physics/src/state/wake.h"
#include "physics/src/world/body_change.h"
#include "physics/src/world/checks.h"

namespace jostle::physics {
namespace {

BodyState state_of_body(const BodySets& sets, std::uint32_t index) {
    const BodyCold& cold = sets.bodies.cold[index];
    const BodyWarm& warm = warm_of(sets, index);
    ASSERT(warm.body == index);
    return {.id = body_id(sets.bodies, index),
            .type = cold.type,
            .pose = pose_of(warm, cold),
            .center = warm.center,
            .linear_velocity = warm.v,
            .angular_velocity = warm.w,
            .mass = cold.mass,
            .inertia = warm.axes * cold.inertia * transpose(warm.axes),
            .awake = cold.set == BodySet::awake && !cold.asleep_in_place,
            .sleep_allowed = cold.sleep_allowed,
            .locks = cold.locks,
            .user_data = cold.user_data};
}

void remove_body(WorldState& world, std::uint32_t body) {
    BodyCold& cold = world.bodies.cold[body];
    // Bodies that rested on it or leaned against it fall, and its island may split.
    wake_neighbours(world, body);
    wake_body(world, body);
    destroy_contacts_of(world, body, world.events.pending.ended);
    while (cold.first_joint != none) destroy_joint(world, world.joints, cold.first_joint / 2);
    for (std::uint32_t s = cold.first_shape; s != none;) {
        const std::uint32_t next = world.shapes.shapes[s].next;
        destroy_proxy(world, s, world.events.pending.left);
        world.shapes.shapes[s] = ShapeRecord{};
        world.shapes.ids.release(s);
        s = next;
    }
    if (cold.island != none) remove_from_island(world, body);
    ASSERT(cold.first_edge == none && cold.constraints == 0);
    leave_set(world, body);
    cold = BodyCold{};
    world.bodies.motion[body] = {};
    world.bodies.ids.release(body);
}

}  // namespace

Result<BodyId> World::create_body(const BodyDef& def) {
    WorldState& world = *state_;
    if (Status s = check_body_in(world.def, def); !s.ok()) return s.error();
    constexpr AxisLocks out_of_plane = lock_z | lock_rotation_x | lock_rotation_y;
    const std::uint32_t index = world.bodies.ids.take();
    ASSERT(world.bodies.motion.size() == world.bodies.cold.size());
    if (index == world.bodies.cold.size()) {
        world.bodies.cold.emplace_back();
        world.bodies.motion.emplace_back();
    }
    world.bodies.cold[index] =
        BodyCold{.type = def.type,
                 .sleep_allowed = def.sleep_allowed,
                 .continuous = def.continuous,
                 .locks = static_cast<AxisLocks>(def.locks | (world.def.planar ? out_of_plane : 0)),
                 .linear_damping = def.linear_damping,
                 .angular_damping = def.angular_damping,
                 .gravity_scale = def.gravity_scale,
                 .mass_override = def.mass,
                 .user_data = def.user_data};
    world.bodies.motion[index] = {};
    BodyWarm warm{.body = index,
                  .center = def.pose.position,
                  .rotation = unit(def.pose.rotation),
                  .v = def.linear_velocity,
                  .w = def.angular_velocity};
    warm.axes = to_matrix(warm.rotation);
    obey_locks(world.bodies.cold[index], warm);
    if (def.type == BodyType::static_body)
        enter_static(world.bodies, warm);
    else
        enter_awake(world.bodies, warm);
    if (def.type == BodyType::dynamic)
        add_to_island(world, create_island(world.islands, world.def), index);
    ASSERT(is_dynamic(world.bodies, index) == (world.bodies.cold[index].island != none));
    update_motion_bound(world, index, expected_dt(world));
    return body_id(world.bodies, index);
}

Result<BodyId> World::create_body(const BodyDef& def, const ShapeDef& shape) {
    return create_body(def, std::span(&shape, 1));
}

Result<BodyId> World::create_body(const BodyDef& def, std::span<const ShapeDef> shapes) {
    // Check everything before creating anything, so that no partial body is left behind.
    if (Status s = check_body_in(state_->def, def); !s.ok()) return s.error();
    if (Status s = check_shapes_in(state_->def, shapes, def.type); !s.ok()) return s.error();
    const Result<BodyId> body = create_body(def);
    if (shapes.empty()) return body;
    // Set all shapes at once: mass and bounds depend on all of them and would be recomputed for
    // each added shape.
    if (const auto created = set_shapes(*body, shapes); !created.ok()) return created.error();
    return body;
}

Result<std::vector<BodyId>> World::create_bodies(std::span<const BodyAndShapes> defs) {
    const auto error_at = [](std::size_t k, const Error& error) {
        return Error{error.code, "bodies[" + std::to_string(k) + "]: " + error.message};
    };
    for (std::size_t k = 0; k < defs.size(); k++) {
        if (Status s = check_body_in(state_->def, defs[k].body); !s.ok())
            return error_at(k, s.error());
        if (Status s = check_shapes_in(state_->def, defs[k].shapes, defs[k].body.type); !s.ok())
            return error_at(k, s.error());
    }
    std::vector<BodyId> created;
    created.reserve(defs.size());
    for (std::size_t k = 0; k < defs.size(); k++) {
        const Result<BodyId> body = create_body(defs[k].body, defs[k].shapes);
        if (!body.ok()) return error_at(k, body.error());
        created.push_back(*body);
    }
    return created;
}

Status World::destroy_body(BodyId body) {
    if (Status s = check_id(state_->bodies, body); !s.ok()) return s;
    remove_body(*state_, body.index);
    return {};
}

Status World::destroy_bodies(std::span<const BodyId> bodies) {
    std::vector<BodyId> sorted(bodies.begin(), bodies.end());
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t k = 0; k < sorted.size(); k++) {
        if (Status s = check_id(state_->bodies, sorted[k]); !s.ok()) return s;
        if (k > 0 && sorted[k] == sorted[k - 1])
            return Error{ErrorCode::invalid_argument, "body {" + std::to_string(sorted[k].index) +
                                                          ", " +
                                                          std::to_string(sorted[k].generation) +
                                                          "} is listed twice; list each body once"};
    }
    for (const BodyId& body : bodies) remove_body(*state_, body.index);
    return {};
}

bool World::contains(BodyId body) const {
    return check_id(state_->bodies, body).ok();
}
bool World::contains(ShapeId shape) const {
    return check_id(state_->shapes, shape).ok();
}

Result<BodyState> World::body(BodyId body) const {
    if (Status s = check_id(state_->bodies, body); !s.ok()) return s.error();
    return state_of_body(*state_, body.index);
}

Result<BodyDef> World::definition(BodyId body) const {
    if (Status s = check_id(state_->bodies, body); !s.ok()) return s.error();
    const BodyState now = state_of_body(*state_, body.index);
    const BodyCold& cold = state_->bodies.cold[body.index];
    return BodyDef{.type = now.type,
                   .pose = now.pose,
                   .linear_velocity = now.linear_velocity,
                   .angular_velocity = now.angular_velocity,
                   .linear_damping = cold.linear_damping,
                   .angular_damping = cold.angular_damping,
                   .gravity_scale = cold.gravity_scale,
                   .sleep_allowed = cold.sleep_allowed,
                   .locks = cold.locks,
                   .continuous = cold.continuous,
                   .mass = cold.mass_override,
                   .user_data = cold.user_data};
}

void World::copy_bodies(std::vector<BodyState>& out) const {
    out.clear();
    for (std::uint32_t i = 0; i < state_->bodies.ids.size(); i++)
        if (state_->bodies.ids.alive(i)) out.push_back(state_of_body(*state_, i));
}

void World::copy_awake_bodies(std::vector<BodyState>& out) const {
    out.clear();
    for (const BodyWarm& warm : state_->bodies.awake)
        out.push_back(state_of_body(*state_, warm.body));
}

std::uint64_t World::static_revision() const {
    return state_->static_revision;
}

std::uint32_t World::body_index_end() const {
    return static_cast<std::uint32_t>(state_->bodies.ids.size());
}

std::vector<BodyId> World::bodies() const {
    std::vector<BodyId> ids;
    for (std::uint32_t i = 0; i < state_->bodies.ids.size(); i++)
        if (state_->bodies.ids.alive(i)) ids.push_back(body_id(state_->bodies, i));
    return ids;
}

}  // namespace jostle::physics
