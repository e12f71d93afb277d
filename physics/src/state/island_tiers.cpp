// SPDX-License-Identifier: MIT
#include "state/island_tiers.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "foundation/check.h"
#include "state/contact_constraints.h"
#include "state/impulse_scale.h"

namespace jostle::physics {
namespace {

template <class Visit>
void for_each_body(const WorldState& world, std::uint32_t island, Visit&& visit) {
    for (std::uint32_t body = world.islands.islands[island].first; body != none;
         body = world.bodies.cold[body].island_next)
        visit(body);
}

void move_contacts(WorldState& world, std::uint32_t body, float scale, bool even) {
    for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t index) {
        const Contact& c = world.contacts.contacts[index];
        if (c.colour < 0 || c.body_a != body) return;
        if (scale != 1 || even) {
            const ContactPlace place = place_of(world, c);
            scale_impulses(place, scale, even);
            if (controls_error(world.def)) forget_pull(place);
        }
        if (c.colour_set != set_of_contact(world, c)) move_contact(world, index);
    });
}

// Errors go with the length of a sub-step at least.
void follow_substeps(IslandError& error, double scale) {
    error.estimate *= scale;
    error.easy = 0;
}

// To move contacts by the ten thousand, one by one, would take as long as several steps. So when
// most of a set goes to one that holds little, the two change places and what is in the wrong one
// moves.
void swap_sets(WorldState& world, ColourSetKey a, ColourSetKey b) {
    std::swap(world.graph.sets[index_of(a)], world.graph.sets[index_of(b)]);
    std::vector<std::uint32_t> others;
    for (const ColourSetKey key : {a, b})
        for (const GraphColour& colour : world.graph.sets[index_of(key)].colours)
            for (const ContactConstraintWideMeta& meta : colour.metas)
                for (const std::uint32_t index : meta.contact) {
                    if (index == no_contact) continue;
                    Contact& c = world.contacts.contacts[index];
                    c.colour_set = key;
                    if (set_of_contact(world, c) != key) others.push_back(index);
                }
    for (const std::uint32_t contact : others) move_contact(world, contact);
}

}  // namespace

std::vector<std::uint32_t> tied_islands(const WorldState& world, std::uint32_t island) {
    std::vector<bool> seen(world.islands.islands.size(), false);
    return tied_islands(world, island, seen);
}

std::vector<std::uint32_t> tied_islands(const WorldState& world, std::uint32_t island,
                                        std::vector<bool>& seen) {
    std::vector<std::uint32_t> tied{island};
    seen[island] = true;
    for (std::size_t k = 0; k < tied.size(); k++)
        for_each_body(world, tied[k], [&](std::uint32_t body) {
            const BodyCold& cold = world.bodies.cold[body];
            if (cold.constraints == 0) return;
            for_each_contact(world.contacts, cold, [&](std::uint32_t index) {
                const Contact& c = world.contacts.contacts[index];
                if (c.colour < 0) return;
                const std::uint32_t other =
                    world.bodies.cold[c.body_a == body ? c.body_b : c.body_a].island;
                if (other == none || seen[other]) return;
                seen[other] = true;
                tied.push_back(other);
            });
        });
    return tied;
}

void move_to_set(WorldState& world, const std::vector<std::uint32_t>& islands, ColourSetKey to) {
    ASSERT(!islands.empty() && to != asleep_set);
    const ColourSetKey from = world.islands.islands[islands.front()].colour_set;
    if (from == to) return;
    const bool other_tier = from.tier != to.tier;
    const double scale = static_cast<double>(substeps_of(from, world)) / substeps_of(to, world);
    // All islands first: contacts ask which set their bodies have.
    std::int64_t contacts = 0;  // those of two bodies twice
    for (const std::uint32_t i : islands) {
        ASSERT(world.islands.islands[i].colour_set == from && !world.islands.islands[i].asleep);
        world.islands.islands[i].colour_set = to;
        if (other_tier) world.islands.islands[i].calm = 0;
        if (scale != 1) follow_substeps(world.islands.islands[i].error, scale);
        for_each_body(world, i,
                      [&](std::uint32_t body) { contacts += world.bodies.cold[body].constraints; });
    }
    const std::int32_t in_from = world.graph.sets[index_of(from)].contacts;
    const std::int32_t in_to = world.graph.sets[index_of(to)].contacts;
    const bool even = other_tier && to.tier > SolverTier::heap;
    if (contacts > in_from && 2 * in_to < in_from) {
        swap_sets(world, from, to);
        if (scale == 1 && !even) return;
    }
    for (const std::uint32_t i : islands)
        for_each_body(world, i, [&](std::uint32_t body) {
            move_contacts(world, body, static_cast<float>(scale), even);
            scale_joints(world, body, scale);
        });
}

void scale_warm_start(WorldState& world, const Island& island, float scale) {
    ASSERT(!island.asleep);
    for (std::uint32_t body = island.first; body != none;
         body = world.bodies.cold[body].island_next)
        for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t index) {
            const Contact& c = world.contacts.contacts[index];
            if (c.colour >= 0 && c.body_a == body) scale_warm_start(place_of(world, c), scale);
        });
}

void match_sets(WorldState& world, std::uint32_t a, std::uint32_t b) {
    const Island &ia = world.islands.islands[a], &ib = world.islands.islands[b];
    ASSERT(!ia.asleep && !ib.asleep);
    if (ia.colour_set == ib.colour_set) return;
    // What touches a heap does not make it slender, nor the other way round; nor tall, when it was
    // content with less at the last look: a ball that left a tall heap and comes back.
    const auto asks = [](const Island& island) {
        const SolverTier tier = island.colour_set.tier;
        return island.calm > 0 ? std::min(tier, SolverTier::slender) : tier;
    };
    const SolverTier a_asks = asks(ia), b_asks = asks(ib);
    const bool alike = ia.colour_set.tier == ib.colour_set.tier || a_asks == b_asks ||
                       (is_usual(a_asks) && is_usual(b_asks));
    const bool a_yields = alike ? ia.bodies < ib.bodies : a_asks < b_asks;
    ColourSetKey to = a_yields ? ib.colour_set : ia.colour_set;
    if (controls_error(world.def)) to.batch = std::max(ia.colour_set.batch, ib.colour_set.batch);
    for (const std::uint32_t island : {a, b})
        if (world.islands.islands[island].colour_set != to)
            move_to_set(world, tied_islands(world, island), to);
}

}  // namespace jostle::physics
