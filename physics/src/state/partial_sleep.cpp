// SPDX-License-Identifier: MIT
#include "physics/src/state/partial_sleep.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/effective_mass.h"
#include "physics/src/constraint_graph/wide_rows.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_load.h"
#include "physics/src/state/joint_graph.h"

namespace jostle::physics {
namespace {

template <class Visit>
void for_each_manifold(const ContactGraph& stores, std::uint32_t body, Visit&& visit) {
    for_each_manifold(stores.contacts, stores.bodies.cold[body], visit);
}

// After one of its bodies fell asleep or woke: moves the contact to its colour set and recomputes
// the effective masses of solved contacts.
void move_to_own_set(ContactGraph& stores, std::uint32_t contact) {
    const Contact& c = stores.contacts.contacts[contact];
    const ColourSetKey target = set_of_contact(stores, c);
    ASSERT(stores.contacts.ids.alive(contact) && c.colour >= 0);
    if (target != c.colour_set) move_contact(stores, contact);
    if (target != asleep_set) rewrite_effective_mass(stores, stores.graph, c);
}

}  // namespace

void hold_still(BodyStore& bodies, std::uint32_t body) {
    BodyCold& cold = bodies.cold[body];
    ASSERT(cold.set == BodySet::awake && !cold.asleep_in_place);
    cold.asleep_in_place = true;
    BodyWarm& warm = bodies.awake[cold.at];
    warm.v = warm.w = {};
    bodies.motion[body].bound = bodies.motion[body].travel;
    bodies.asleep_in_place++;
    ASSERT(bodies.asleep_in_place <= bodies.awake.size());
}

void sleep_in_place(ContactGraph& stores, std::span<const std::uint32_t> bodies) {
    for (const std::uint32_t body : bodies)
        for_each_manifold(stores, body, [&](std::uint32_t contact) { save_load(stores, contact); });
    for (const std::uint32_t body : bodies) hold_still(stores.bodies, body);
    for (const std::uint32_t body : bodies)
        for_each_manifold(stores, body,
                          [&](std::uint32_t contact) { move_to_own_set(stores, contact); });
}

void wake_in_place(ContactGraph& stores, std::uint32_t body) {
    BodyCold& cold = stores.bodies.cold[body];
    if (!cold.asleep_in_place) return;
    ASSERT(cold.set == BodySet::awake && stores.bodies.asleep_in_place > 0);
    cold.asleep_in_place = false;
    stores.bodies.asleep_in_place--;
    for_each_manifold(stores, body,
                      [&](std::uint32_t contact) { move_to_own_set(stores, contact); });
}

namespace {

// Limits the times at rest to `sleep_time`.
void wake_jointed(WorldState& world, std::uint32_t body, double sleep_time,
                  std::vector<BodyId>& woke) {
    if (!world.bodies.cold[body].asleep_in_place) return;
    for (const std::uint32_t part :
         jointed_with(world.bodies, world.joints, world.scratch, body).bodies) {
        wake_in_place(world, part);
        BodyWarm& warm = warm_of(world, part);
        warm.sleep_time = minimum(warm.sleep_time, sleep_time);
        woke.push_back(body_id(world.bodies, part));
    }
}

}  // namespace

void wake_from_partial_sleep(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke) {
    wake_jointed(world, body, 0, woke);
}

void wake_briefly(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke) {
    wake_jointed(world, body,
                 tuning::partial_sleep_time - tuning::partial_sleep_interval * world.last_dt, woke);
}

void wake_around(WorldState& world, std::uint32_t body, double mass, std::vector<BodyId>& woke) {
    ASSERT(mass >= 0);
    ASSERT(is_dynamic(world.bodies, body));
    std::vector<std::uint32_t> visited{body};
    auto& seen = world.scratch.visited;
    seen.resize(world.bodies.cold.size(), 0);
    seen[body] = 1;
    double sum = world.bodies.cold[body].mass;
    for (std::size_t k = 0; k < visited.size() && sum < mass; k++)
        for_each_manifold(world, visited[k], [&](std::uint32_t contact) {
            const Contact& c = world.contacts.contacts[contact];
            const std::uint32_t other = c.body_a == visited[k] ? c.body_b : c.body_a;
            if (!world.bodies.cold[other].asleep_in_place || seen[other] != 0) return;
            seen[other] = 1;
            visited.push_back(other);
            sum += world.bodies.cold[other].mass;
        });
    for (const std::uint32_t near : visited) seen[near] = 0;
    std::sort(visited.begin(), visited.end());
    for (const std::uint32_t near : visited) wake_briefly(world, near, woke);
    warm_of(world, body).sleep_time = 0;
}

}  // namespace jostle::physics
