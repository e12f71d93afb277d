// SPDX-License-Identifier: MIT
#include "physics/src/stages/contacts/call_contact_listeners.h"

#include "jostle/base/check.h"
#include "jostle/physics/step_listener.h"
#include "physics/src/constraint_graph/wide_rows.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_modifiers.h"

namespace jostle::physics {
namespace {

Vec3 velocity_at(const BodyWarm& body, Vec3 point) {
    return body.v + cross(body.w, point - body.center);
}

bool is_same(const ContactModifier& a, const ContactModifier& b) {
    return a.friction == b.friction && a.restitution == b.restitution &&
           a.surface_velocity == b.surface_velocity && a.enabled == b.enabled;
}

// Listeners may return any value.
void sanitize(ContactModifier& modifier) {
    if (!(modifier.friction >= 0 && modifier.friction <= 1e6)) modifier.friction = 0;
    modifier.restitution = modifier.restitution >= 0 ? minimum(modifier.restitution, 1) : 0;
    if (!is_finite(modifier.surface_velocity)) modifier.surface_velocity = {};
}

}  // namespace

ContactModifier call_contact_listeners(const ListenerStore& listeners, const ShapedBodies& stores,
                                       const PreSolveContact& m, ContactModifier modifier) {
    ASSERT(listeners.stepping != nullptr && has_pre_solve_listeners(listeners));
    PreSolve pair{.world = *listeners.stepping,
                  .shape_a = shape_id(stores.shapes, m.shape_a),
                  .shape_b = shape_id(stores.shapes, m.shape_b),
                  .body_a = body_id(stores.bodies, stores.shapes.shapes[m.shape_a].body),
                  .body_b = body_id(stores.bodies, stores.shapes.shapes[m.shape_b].body),
                  .normal = m.normal,
                  .point = m.point,
                  .velocity = m.velocity,
                  .friction = modifier.friction,
                  .restitution = modifier.restitution,
                  .surface_velocity = modifier.surface_velocity,
                  .enabled = modifier.enabled};
    for (const auto& [listener, hooks] : listeners.order)
        if (hooks.pre_solve) listener->pre_solve(pair);
    modifier.friction = pair.friction;
    modifier.restitution = pair.restitution;
    modifier.surface_velocity = pair.surface_velocity;
    modifier.enabled = pair.enabled;
    sanitize(modifier);
    return modifier;
}

bool modify_contact(WorldState& world, std::uint32_t index) {
    const Contact& c = world.contacts.contacts[index];
    const ContactLaneRef lane_ref = lane_ref_of(world.graph, c);
    const BodyWarm &a = warm_of(world, c.body_a), &b = warm_of(world, c.body_b);
    const Vec3 point = a.center + get_lane(lane_ref.block->arm_a, lane_ref.lane);
    const ContactModifier given = material_modifier(world, c.shape_a, c.shape_b);
    ContactModifier modifier =
        call_contact_listeners(world.listeners, world,
                               {c.shape_a, c.shape_b, normal_of(lane_ref), point,
                                velocity_at(b, point) - velocity_at(a, point)},
                               given);
    if (is_same(modifier, given)) return false;
    modifier.contact = index;
    set_modifier(world.contacts, modifier);
    return true;
}

}  // namespace jostle::physics
