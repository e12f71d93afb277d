// SPDX-License-Identifier: MIT
#include "physics/src/state/islands.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/state/island_tiers.h"

namespace jostle::physics {

std::uint32_t create_island(IslandStore& islands, const WorldDef& def) {
    const std::uint32_t index = islands.ids.take();
    if (index == islands.islands.size()) islands.islands.emplace_back();
    islands.islands[index] = Island{};
    if (controls_error(def)) {
        islands.islands[index].colour_set.batch = initial_substep_level;
        islands.islands[index].error.target_level = initial_substep_level;
    }
    return index;
}

void add_to_island(BodySets& sets, std::uint32_t island_index, std::uint32_t body) {
    Island& island = sets.islands.islands[island_index];
    BodyCold& cold = sets.bodies.cold[body];
    ASSERT(sets.islands.ids.alive(island_index));
    ASSERT(cold.island == none && cold.type == BodyType::dynamic);
    ASSERT((island.first == none) == (island.bodies == 0));
    cold.island = island_index;
    cold.island_prev = island.last;
    cold.island_next = none;
    if (island.last != none)
        sets.bodies.cold[island.last].island_next = body;
    else
        island.first = body;
    island.last = body;
    island.bodies++;
    island.too_dense_for = -1;
    island.mass += cold.mass;
}

void remove_from_island(BodySets& sets, std::uint32_t body) {
    BodyCold& cold = sets.bodies.cold[body];
    const std::uint32_t index = cold.island;
    ASSERT(index != none);
    ASSERT(sets.islands.ids.alive(index));
    Island& island = sets.islands.islands[index];
    if (cold.island_prev != none)
        sets.bodies.cold[cold.island_prev].island_next = cold.island_next;
    else
        island.first = cold.island_next;
    if (cold.island_next != none)
        sets.bodies.cold[cold.island_next].island_prev = cold.island_prev;
    else
        island.last = cold.island_prev;
    cold.island = cold.island_prev = cold.island_next = none;
    ASSERT(island.bodies > 0);
    island.mass -= sets.bodies.cold[body].mass;
    island.too_dense_for = -1;
    if (--island.bodies == 0) {
        island = Island{};
        sets.islands.ids.release(index);
    }
}

namespace {

// An error that is unknown for one island is unknown for both.
IslandError joined(const IslandError& a, const IslandError& b) {
    return {.estimate = a.estimate == 0 || b.estimate == 0 ? 0 : maximum(a.estimate, b.estimate),
            .target_level = std::max(a.target_level, b.target_level)};
}

}  // namespace

void join_islands(ContactGraph& stores, JointStore& joints, std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    ASSERT(stores.islands.ids.alive(a) && stores.islands.ids.alive(b));
    match_sets(stores, joints, a, b);
    const Island &ia = stores.islands.islands[a], &ib = stores.islands.islands[b];
    ASSERT(!ia.asleep && !ib.asleep);
    ASSERT(ia.bodies > 0 && ib.bodies > 0);
    ASSERT(ia.colour_set == ib.colour_set);
    if (ia.bodies < ib.bodies || (ia.bodies == ib.bodies && b < a)) std::swap(a, b);
    Island& into = stores.islands.islands[a];
    Island& from = stores.islands.islands[b];
    for (std::uint32_t body = from.first; body != none; body = stores.bodies.cold[body].island_next)
        stores.bodies.cold[body].island = a;
    stores.bodies.cold[into.last].island_next = from.first;
    stores.bodies.cold[from.first].island_prev = into.last;
    into.last = from.last;
    into.bodies += from.bodies;
    ASSERT(into.bodies <= stores.bodies.awake.size());
    into.too_dense_for = -1;
    into.may_be_split = into.may_be_split || from.may_be_split;
    into.uneven = into.uneven || from.uneven;
    into.split_at = std::max(into.split_at, from.split_at);
    into.mass += from.mass;
    into.remaining_load = minimum(into.remaining_load, from.remaining_load);
    into.error = joined(into.error, from.error);
    from = Island{};
    stores.islands.ids.release(b);
}

namespace {

// Adds the connected component of `seed` to `island`. Bodies that are not yet reached have no
// island.
void flood(WorldState& world, std::uint32_t island, std::uint32_t seed) {
    std::vector<std::uint32_t>& stack = world.scratch.stack;
    stack.assign(1, seed);
    add_to_island(world, island, seed);
    while (!stack.empty()) {
        const std::uint32_t body = stack.back();
        stack.pop_back();
        const auto join = [&](std::uint32_t other) {
            if (!is_dynamic(world.bodies, other) || world.bodies.cold[other].island != none) return;
            add_to_island(world, island, other);
            stack.push_back(other);
        };
        for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t contact) {
            const Contact& c = world.contacts.contacts[contact];
            if (c.touching) join(c.body_a == body ? c.body_b : c.body_a);
        });
        for_each_joint(world.joints, world.bodies.cold[body], [&](std::uint32_t joint) {
            const Joint& j = world.joints.joints[joint];
            join(j.body_a == body ? j.body_b : j.body_a);
        });
    }
}

}  // namespace

void split_island(WorldState& world, std::uint32_t island) {
    ASSERT(world.islands.ids.alive(island) && !world.islands.islands[island].asleep);
    std::vector<std::uint32_t> bodies;
    for (std::uint32_t b = world.islands.islands[island].first; b != none;
         b = world.bodies.cold[b].island_next)
        bodies.push_back(b);
    // The components inherit all properties except the bodies.
    const Island& original = world.islands.islands[island];
    const Island prototype{.colour_set = original.colour_set,
                           .calm = original.calm,
                           .uneven = original.uneven,
                           .split_at = world.steps,
                           .error = original.error};
    world.islands.islands[island] = prototype;
    for (const std::uint32_t body : bodies) world.bodies.cold[body].island = none;
    bool first = true;
    for (const std::uint32_t body : bodies) {
        if (world.bodies.cold[body].island != none) continue;
        const std::uint32_t component = first ? island : create_island(world.islands, world.def);
        world.islands.islands[component] = prototype;
        flood(world, component, body);
        first = false;
    }
}

void find_awake_islands(const BodySets& sets, std::vector<std::uint32_t>& islands) {
    constexpr std::size_t scan_worth = 8;  // islands that can be scanned in the time to sort one
    islands.clear();
    const std::uint32_t count = sets.islands.ids.size();
    if (scan_worth * sets.bodies.awake.size() > count) {
        for (std::uint32_t i = 0; i < count; i++)
            if (sets.islands.ids.alive(i) && !sets.islands.islands[i].asleep) islands.push_back(i);
        return;
    }
    for (const BodyWarm& warm : sets.bodies.awake) {
        const std::uint32_t island = sets.bodies.cold[warm.body].island;
        if (island != none) islands.push_back(island);  // kinematic bodies have none
    }
    std::sort(islands.begin(), islands.end());
    islands.erase(std::unique(islands.begin(), islands.end()), islands.end());
}

}  // namespace jostle::physics
