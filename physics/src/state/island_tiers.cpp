// SPDX-License-Identifier: MIT
#include "physics/src/state/island_tiers.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/wide_rows.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/impulse_scale.h"

namespace jostle::physics {
namespace {

template <class Visit>
void for_each_body(const BodySets& sets, std::uint32_t island, Visit&& visit) {
    for (std::uint32_t body = sets.islands.islands[island].first; body != none;
         body = sets.bodies.cold[body].island_next)
        visit(body);
}

// Scaling to another sub-step length.
struct Rescale {
    float scale = 1;
    bool even = false;  // the points of a manifold share its load
};

void rescale(ConstraintGraph& graph, const WorldDef& def, const Contact& c, Rescale by) {
    if (by.scale == 1 && !by.even) return;
    ASSERT(by.scale > 0);
    const ContactLaneRef lane_ref = lane_ref_of(graph, c);
    scale_impulses(lane_ref, by.scale, by.even);
    if (controls_error(def)) clear_negative_mean_impulse(lane_ref);
}

// `resting_only`: the other contacts have already been moved.
void move_contacts(ContactGraph& stores, std::uint32_t body, Rescale by, bool resting_only) {
    for_each_manifold(stores.contacts, stores.bodies.cold[body], [&](std::uint32_t index) {
        const Contact& c = stores.contacts.contacts[index];
        if (c.body_a != body || (resting_only && c.colour_set != asleep_set)) return;
        rescale(stores.graph, stores.def, c, by);
        if (c.colour_set != set_of_contact(stores, c)) move_contact(stores, index);
    });
}

// Errors grow at least linearly with the length of a sub-step.
void follow_substeps(IslandError& error, double scale) {
    error.estimate *= scale;
    error.easy = 0;
}

// Moving tens of thousands of contacts one by one would take as long as several steps. If most
// contacts of a set move to a set with few contacts, the two sets are swapped and only misplaced
// contacts are moved. Calls moved(contact) for contacts that change sets.
template <class Moved>
void swap_sets(ContactGraph& stores, ColourSetKey from, ColourSetKey to, Moved&& moved) {
    std::swap(stores.graph.sets[index_of(from)], stores.graph.sets[index_of(to)]);
    std::vector<std::uint32_t> others;
    for (const ColourSetKey key : {from, to})
        for (const GraphColour& colour : stores.graph.sets[index_of(key)].colours)
            for (const ContactConstraintWideMeta& meta : colour.metas)
                for (const std::uint32_t index : meta.contact) {
                    if (index == no_contact) continue;
                    Contact& c = stores.contacts.contacts[index];
                    c.colour_set = key;
                    if (set_of_contact(stores, c) != key)
                        others.push_back(index);
                    else if (key == to)
                        moved(c);
                }
    for (const std::uint32_t contact : others) move_contact(stores, contact);
}

}  // namespace

std::vector<std::uint32_t> coupled_islands(const BodySets& sets, const ContactStore& contacts,
                                           std::uint32_t island) {
    std::vector<bool> seen(sets.islands.islands.size(), false);
    std::vector<std::uint32_t> coupled{island};
    seen[island] = true;
    for (std::size_t k = 0; k < coupled.size(); k++)
        for_each_body(sets, coupled[k], [&](std::uint32_t body) {
            for_each_manifold(contacts, sets.bodies.cold[body], [&](std::uint32_t index) {
                const Contact& c = contacts.contacts[index];
                const std::uint32_t other =
                    sets.bodies.cold[c.body_a == body ? c.body_b : c.body_a].island;
                if (other == none || seen[other]) return;
                seen[other] = true;
                coupled.push_back(other);
            });
        });
    return coupled;
}

std::vector<std::uint32_t> few_coupled_islands(const BodySets& sets, const ContactStore& contacts,
                                               std::uint32_t island, std::uint32_t max_bodies) {
    std::vector<std::uint32_t> coupled{island};
    std::uint32_t bodies = sets.islands.islands[island].bodies;
    for (std::size_t k = 0; k < coupled.size() && bodies <= max_bodies; k++)
        for_each_body(sets, coupled[k], [&](std::uint32_t body) {
            for_each_manifold(contacts, sets.bodies.cold[body], [&](std::uint32_t index) {
                const Contact& c = contacts.contacts[index];
                const std::uint32_t other =
                    sets.bodies.cold[c.body_a == body ? c.body_b : c.body_a].island;
                if (other == none || bodies > max_bodies ||
                    std::find(coupled.begin(), coupled.end(), other) != coupled.end())
                    return;
                coupled.push_back(other);
                bodies += sets.islands.islands[other].bodies;
            });
        });
    if (bodies > max_bodies) coupled.clear();
    return coupled;
}

CoupledIslands::CoupledIslands(const ContactGraph& stores) : first_(stores.islands.islands.size()) {
    const auto count = static_cast<std::uint32_t>(first_.size());
    for (std::uint32_t i = 0; i < count; i++) first_[i] = i;
    const auto root = [&](std::uint32_t i) {
        while (first_[i] != i) i = first_[i] = first_[first_[i]];
        return i;
    };
    for_each_colour(stores.graph.sets, [&](const GraphColour& colour) {
        for (const ContactConstraintWideMeta& meta : colour.metas)
            for (const std::uint32_t index : meta.contact) {
                if (index == no_contact) continue;
                const Contact& c = stores.contacts.contacts[index];
                const std::uint32_t a = stores.bodies.cold[c.body_a].island,
                                    b = stores.bodies.cold[c.body_b].island;
                if (a == b || a == none || b == none) continue;
                const std::uint32_t of_a = root(a), of_b = root(b);
                first_[std::max(of_a, of_b)] = std::min(of_a, of_b);
            }
    });
    start_.assign(count + 1, 0);
    for (std::uint32_t i = 0; i < count; i++) {
        first_[i] = root(i);
        start_[first_[i] + 1]++;
    }
    for (std::uint32_t i = 0; i < count; i++) start_[i + 1] += start_[i];
    ASSERT(start_.back() == count);
    members_.resize(count);
    std::vector<std::uint32_t> next = start_;
    for (std::uint32_t i = 0; i < count; i++) members_[next[first_[i]]++] = i;
}

namespace {

// Whether the points of a contact overlap by more than a small fraction of the first body.
bool overlaps_deeply(const ContactLaneRef& at) {
    double deepest = 0;
    for (const auto& gap : at.block->gap) deepest = minimum(deepest, double{gap[at.lane]});
    return -deepest > tuning::squeezed_share * length(get_lane(at.block->arm_a, at.lane));
}

// Whether the islands stand without being pushed out of deep overlaps.
bool all_rest(const ContactGraph& stores, std::span<const std::uint32_t> islands) {
    bool rest = true;
    for (const std::uint32_t i : islands)
        for_each_body(stores, i, [&](std::uint32_t body) {
            rest = rest && length_squared(warm_of(stores, body).v) <
                               tuning::sleep_speed * tuning::sleep_speed;
            for_each_manifold(stores.contacts, stores.bodies.cold[body], [&](std::uint32_t index) {
                rest = rest &&
                       !overlaps_deeply(lane_ref_of(stores.graph, stores.contacts.contacts[index]));
            });
        });
    return rest;
}

}  // namespace

void move_to_set(ContactGraph& stores, JointStore& joints, std::span<const std::uint32_t> islands,
                 ColourSetKey to) {
    ASSERT(!islands.empty() && to != asleep_set);
    const ColourSetKey from = stores.islands.islands[islands.front()].colour_set;
    if (from == to) return;
    // Sweeps would keep the impulses of heavy loads after the bodies have moved, and throw light
    // bodies at 100 m/s.
    if (from.tier == SolverTier::direct && to.tier != SolverTier::direct &&
        !all_rest(stores, islands))
        for (const std::uint32_t i : islands)
            scale_warm_start(stores, stores.islands.islands[i], 0);
    const bool other_tier = from.tier != to.tier;
    const double scale = static_cast<double>(substeps_of(from, stores)) / substeps_of(to, stores);
    ASSERT(scale > 0 && from != asleep_set);
    // Update all islands first, because the set of a contact depends on the sets of its bodies.
    std::int64_t contacts = 0;  // contacts of two dynamic bodies count twice
    for (const std::uint32_t i : islands) {
        ASSERT(stores.islands.islands[i].colour_set == from && !stores.islands.islands[i].asleep);
        stores.islands.islands[i].colour_set = to;
        if (other_tier) stores.islands.islands[i].calm = 0;
        if (scale != 1) follow_substeps(stores.islands.islands[i].error, scale);
        for_each_body(stores, i, [&](std::uint32_t body) {
            contacts += stores.bodies.cold[body].constraints;
        });
    }
    const std::int32_t in_from = stores.graph.sets[index_of(from)].contacts;
    const std::int32_t in_to = stores.graph.sets[index_of(to)].contacts;
    ASSERT(in_from >= 0 && in_to >= 0);
    const Rescale by{static_cast<float>(scale), other_tier && to.tier > SolverTier::pile};
    const bool swap = contacts > in_from && 2 * in_to < in_from;
    if (swap)
        swap_sets(stores, from, to,
                  [&](const Contact& c) { rescale(stores.graph, stores.def, c, by); });
    // Contacts asleep in place have a separate set.
    const bool walk = !swap || stores.bodies.asleep_in_place > 0;
    if (!walk && scale == 1) return;
    for (const std::uint32_t i : islands)
        for_each_body(stores, i, [&](std::uint32_t body) {
            if (walk) move_contacts(stores, body, by, swap);
            scale_joints(stores.bodies, joints, body, scale);
        });
}

void scale_warm_start(ContactGraph& stores, const Island& island, float scale) {
    ASSERT(!island.asleep);
    ASSERT(scale >= 0);
    for (std::uint32_t body = island.first; body != none;
         body = stores.bodies.cold[body].island_next)
        for_each_manifold(stores.contacts, stores.bodies.cold[body], [&](std::uint32_t index) {
            const Contact& c = stores.contacts.contacts[index];
            if (c.body_a == body) scale_warm_start(lane_ref_of(stores.graph, c), scale);
        });
}

void match_sets(ContactGraph& stores, JointStore& joints, std::uint32_t a, std::uint32_t b) {
    const Island &ia = stores.islands.islands[a], &ib = stores.islands.islands[b];
    ASSERT(!ia.asleep && !ib.asleep);
    if (ia.colour_set == ib.colour_set) return;
    // A body that touches a pile does not make it slender, nor vice versa. It does not make it tall
    // either if the last test of the pile required less, as for a ball that left a tall pile and
    // returns.
    const auto required_tier = [](const Island& island) {
        const SolverTier tier = island.colour_set.tier;
        return island.calm > 0 ? std::min(tier, SolverTier::slender) : tier;
    };
    const SolverTier tier_a = required_tier(ia), tier_b = required_tier(ib);
    const bool alike = ia.colour_set.tier == ib.colour_set.tier || tier_a == tier_b ||
                       (is_usual(tier_a) && is_usual(tier_b));
    // Islands that are solved directly are small and give way to a large one.
    const auto is_large = [](const Island& island) {
        return island.bodies > tuning::max_group_bodies;
    };
    const bool direct = std::max(tier_a, tier_b) == SolverTier::direct;
    const bool by_size = alike || (direct && (is_large(ia) || is_large(ib)));
    const bool a_yields = by_size ? ia.bodies < ib.bodies : tier_a < tier_b;
    ColourSetKey to = a_yields ? ib.colour_set : ia.colour_set;
    if (batches_differ(stores)) to.batch = std::max(ia.colour_set.batch, ib.colour_set.batch);
    ASSERT(to.tier != SolverTier::asleep);
    for (const std::uint32_t island : {a, b})
        if (stores.islands.islands[island].colour_set != to)
            move_to_set(stores, joints, coupled_islands(stores, stores.contacts, island), to);
}

}  // namespace jostle::physics
