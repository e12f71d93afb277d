// SPDX-License-Identifier: MIT
#include "stages/finalize/quarantine.h"

#include <algorithm>

#include "foundation/check.h"
#include "stages/step_scratch.h"
#include "state/contact_constraints.h"
#include "state/shape_proxy.h"

namespace jostle::physics {
namespace {

// Impulses that may be as unsound as the body's state are forgotten; the manifold is rebuilt in the
// next step.
void clear_impulses(const ContactPlace& place) {
    const int lane = place.lane;
    for (auto& lambda : place.block->lambda) lambda[lane] = 0;
    for (auto& friction : place.block->friction) friction[lane] = 0;
    place.block->torsion[lane] = 0;
    for (auto& mean_impulse : place.block->mean_impulse) mean_impulse[lane] = 0;
    place.meta->moved[lane] = 0;
    place.meta->set(LaneFlag::needs_rebuild, lane, true);
}

void clear_impulses(Joint& joint) {
    joint.point = joint.angular = joint.friction = joint.force = joint.torque = {};
    joint.lower = joint.upper = joint.swing = joint.spring = joint.motor = 0;
    std::ranges::fill(joint.memory, 0);  // as at its beginning
}

}  // namespace

Skipped quarantine(StepContext& step) {
    if (step.world.bodies.awake.empty()) return nobody_awake;
    WorldState& world = step.world;
    // What woke since then was at rest.
    const std::vector<std::uint8_t>& not_finite = step.scratch.finalize.not_finite;
    ASSERT(not_finite.size() <= world.bodies.awake.size());
    for (std::uint32_t i = 0; i < not_finite.size(); i++) {
        if (not_finite[i] == 0) continue;
        const std::uint32_t body = world.bodies.awake[i].body;
        ASSERT(is_finite(world.bodies.awake[i].center));
        world.events.quarantined.push_back(body_id(world, body));
        for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t contact) {
            const Contact& c = world.contacts.contacts[contact];
            if (c.colour >= 0) clear_impulses(place_of(world, c));
        });
        for_each_joint(world.joints, world.bodies.cold[body],
                       [&](std::uint32_t joint) { clear_impulses(world.joints.joints[joint]); });
        update_motion_bound(world, body, step.dt);
    }
    return ran;
}

}  // namespace jostle::physics
