// SPDX-License-Identifier: MIT
#include "physics/src/state/wake.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/state/island_sleep.h"
#include "physics/src/state/partial_sleep.h"

namespace jostle::physics {

void ensure_awake(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke) {
    const BodyCold& cold = world.bodies.cold[body];
    ASSERT(cold.type == BodyType::dynamic);
    if (cold.set == BodySet::sleeping) wake_island(world, cold.island, woke);
    wake_from_partial_sleep(world, body, woke);
}

void apply_wake_requests(WorldState& world, std::vector<BodyId>& woke) {
    WakeRequests& requests = world.wake_requests;
    // A caller may have destroyed or woken a body in the meantime.
    std::erase_if(requests, [&](const WakeRequest& r) {
        if (!world.bodies.ids.alive(r.body)) return true;
        const BodyCold& cold = world.bodies.cold[r.body];
        return cold.set != BodySet::sleeping && !cold.asleep_in_place;
    });
    std::sort(requests.begin(), requests.end());
    ASSERT(requests.empty() || requests.back().body < world.bodies.cold.size());
    std::vector<std::uint32_t> islands;
    for (const WakeRequest& r : requests)
        if (world.bodies.cold[r.body].set == BodySet::sleeping)
            islands.push_back(world.bodies.cold[r.body].island);
    std::sort(islands.begin(), islands.end());
    islands.erase(std::unique(islands.begin(), islands.end()), islands.end());
    for (const std::uint32_t island : islands) wake_island(world, island, woke);
    for (const bool briefly : {false, true})
        for (const WakeRequest& r : requests) {
            if (r.briefly != briefly || !world.bodies.cold[r.body].asleep_in_place) continue;
            if (briefly)
                wake_briefly(world, r.body, woke);
            else
                wake_around(world, r.body, r.mass, woke);
        }
    ASSERT(std::none_of(requests.begin(), requests.end(), [&](const WakeRequest& r) {
        return world.bodies.cold[r.body].set == BodySet::sleeping;
    }));
    requests.clear();
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
        const std::uint32_t other = j.body_a == body ? j.body_b : j.body_a;
        if (other != none) others.push_back(other);
    });
    for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t contact) {
        const Contact& c = world.contacts.contacts[contact];
        others.push_back(c.body_a == body ? c.body_b : c.body_a);
    });
    std::sort(others.begin(), others.end());
    for (const std::uint32_t other : others) wake_body(world, other);
}

}  // namespace jostle::physics
