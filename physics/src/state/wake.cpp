// SPDX-License-Identifier: MIT
#include "state/wake.h"

#include <algorithm>

#include "state/island_sleep.h"
#include "state/partial_sleep.h"

namespace jostle::physics {

void ensure_awake(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke) {
    const BodyCold& cold = world.bodies.cold[body];
    if (cold.set == BodySet::sleeping) wake_island(world, cold.island, woke);
    wake_from_partial_sleep(world, body, woke);
}

void wake_body(WorldState& world, std::uint32_t body) {
    const BodyCold& cold = world.bodies.cold[body];
    if (cold.type != BodyType::dynamic) return;
    ensure_awake(world, body, world.events.pending.woke);
    warm_of(world, body).sleep_time = 0;
}

void wake_neighbours(WorldState& world, std::uint32_t body) {
    std::vector<std::uint32_t> others;
    for_each_joint(world.joints, world.bodies.cold[body], [&](std::uint32_t joint) {
        const Joint& j = world.joints.joints[joint];
        others.push_back(j.body_a == body ? j.body_b : j.body_a);
    });
    for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t contact) {
        const Contact& c = world.contacts.contacts[contact];
        others.push_back(c.body_a == body ? c.body_b : c.body_a);
    });
    std::sort(others.begin(), others.end());
    for (const std::uint32_t other : others) wake_body(world, other);
}

}  // namespace jostle::physics
