// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <algorithm>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

// A manifold may be as invalid as the body's state. It is left without points and impulses until it
// is rebuilt in the next step.
void clear_manifold(const ContactLaneRef& lane_ref) {
    const int lane = lane_ref.lane;
    for (int row = first_saved_row; row < wide_rows; row++) {
        float& value = float_at(*lane_ref.block, row, lane);
        if (!(absolute(double{value}) <= 1e30)) value = 0;
    }
    for (int k = 0; k < 4; k++) {
        lane_ref.block->gap[k][lane] = no_point;
        lane_ref.block->lambda[k][lane] = lane_ref.block->mean_impulse[k][lane] = 0;
    }
    for (auto& friction : lane_ref.block->friction) friction[lane] = 0;
    lane_ref.block->torsion[lane] = 0;
    for (auto& roll : lane_ref.rolling->roll) roll[lane] = 0;
    lane_ref.meta->moved[lane] = 0;
    lane_ref.meta->set(LaneFlag::needs_rebuild, lane, true);
}

void clear_impulses(Joint& joint) {
    joint.point = joint.angular = joint.friction = joint.force = joint.torque = {};
    joint.lower = joint.upper = joint.swing = joint.spring = joint.motor = 0;
    std::ranges::fill(joint.memory, 0);  // as initially
}

// The separation bound of a pair depends on the motion of its bodies. The pair is tested in the
// next step.
void clear_bounds(ContactStore& store, std::vector<std::uint32_t>& contacts) {
    std::sort(contacts.begin(), contacts.end());
    for (const std::uint32_t contact : contacts) store.contacts[contact].limit = -1;
    for (SeparationBound& bound : store.bounds)
        if (std::binary_search(contacts.begin(), contacts.end(), bound.contact))
            bound = {.contact = bound.contact, .body_a = bound.body_a, .body_b = bound.body_b};
}

}  // namespace

Skipped quarantine(StepContext& step) {
    if (step.world.bodies.awake.empty()) return no_awake_bodies;
    WorldState& world = step.world;
    // Bodies that woke since then were at rest.
    const std::vector<std::uint8_t>& not_finite = step.scratch.finalize.not_finite;
    ASSERT(not_finite.size() <= world.bodies.awake.size());
    std::vector<std::uint32_t> contacts;
    for (std::uint32_t i = 0; i < not_finite.size(); i++) {
        if (not_finite[i] == 0) continue;
        const std::uint32_t body = world.bodies.awake[i].body;
        ASSERT(is_finite(world.bodies.awake[i].center));
        ASSERT(is_finite(world.bodies.awake[i].v) && is_finite(world.bodies.awake[i].w));
        world.events.quarantined.push_back(body_id(world.bodies, body));
        for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t contact) {
            const Contact& c = world.contacts.contacts[contact];
            if (c.colour >= 0) clear_manifold(lane_ref_of(world.graph, c));
            contacts.push_back(contact);
        });
        for_each_joint(world.joints, world.bodies.cold[body],
                       [&](std::uint32_t joint) { clear_impulses(world.joints.joints[joint]); });
        update_motion_bound(world, body, step.dt);
    }
    if (!contacts.empty()) clear_bounds(world.contacts, contacts);
    return ran;
}

}  // namespace jostle::physics
