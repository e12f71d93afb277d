// SPDX-License-Identifier: MIT
#include "physics/src/stages/islands/island_stages.h"

#include <algorithm>
#include <cstdint>
#include <queue>
#include <tuple>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/island_tiers.h"

namespace jostle::physics {
namespace {

constexpr std::uint8_t finest = batch_count - 1;

int substeps_at(const SteppingState& stepping, const Island& island, std::uint8_t substep_level) {
    return substeps_of({island.colour_set.tier, substep_level}, stepping);
}

// Factor by which errors grow at another sub-step level: first-order.
double growth(const SteppingState& stepping, const Island& island, std::uint8_t substep_level) {
    return static_cast<double>(substeps_of(island.colour_set, stepping)) /
           substeps_at(stepping, island, substep_level);
}

// Updates the target level after an error measurement.
void choose_target_level(const SteppingState& stepping, Island& island) {
    IslandError& error = island.error;
    ASSERT(error.fresh && error.estimate > 0);
    error.fresh = false;
    const std::uint8_t now = island.colour_set.batch;
    const double tolerance = stepping.def.tolerance;
    if (error.estimate > tolerance) {
        error.target_level = std::min<std::uint8_t>(now + 1, finest);
        error.easy = 0;
        return;
    }
    const bool easy = now > 0 && error.estimate * growth(stepping, island, now - 1) <=
                                     tuning::substep_level_reserve * tolerance;
    error.easy = easy ? static_cast<std::uint8_t>(error.easy + 1) : 0;
    error.target_level = now;
    if (error.easy < tuning::substep_level_patience) return;
    error.target_level = now - 1;
    error.easy = 0;
}

// Islands coupled by manifolds, which have the same sub-step level.
struct CoupledGroup {
    std::span<const std::uint32_t> islands;
    std::uint8_t substep_level = 0;  // target level
    double error = 0;
    std::int64_t bodies = 0;
};

CoupledGroup measured(const IslandStore& store, const WorldDef& def,
                      std::span<const std::uint32_t> islands) {
    CoupledGroup group{.islands = islands};
    for (const std::uint32_t i : group.islands) {
        const Island& island = store.islands[i];
        group.substep_level = std::max(group.substep_level, island.error.target_level);
        group.error =
            maximum(group.error, island.error.estimate > 0 ? island.error.estimate : def.tolerance);
        group.bodies += island.bodies;
    }
    return group;
}

void move(ContactGraph& stores, JointStore& joints, const CoupledGroup& group) {
    const ColourSetKey from = stores.islands.islands[group.islands.front()].colour_set;
    move_to_set(stores, joints, group.islands, {from.tier, group.substep_level});
}

bool is_awake(const IslandStore& islands, std::uint32_t island) {
    return islands.ids.alive(island) && !islands.islands[island].asleep;
}

// Returns whether contacts or joints make the solver move the body.
bool is_held(const BodyCold& cold) {
    return cold.island != none && !cold.asleep_in_place &&
           (cold.constraints > 0 || cold.first_joint != none);
}

std::vector<CoupledGroup> find_active_groups(const BodySets& sets, const WorldDef& def,
                                             const CoupledIslands& coupled) {
    std::vector<CoupledGroup> groups;
    std::vector<bool> visited(sets.islands.islands.size(), false);  // by first island of a group
    for (const BodyWarm& warm : sets.bodies.awake) {
        const BodyCold& cold = sets.bodies.cold[warm.body];
        if (!is_held(cold)) continue;
        const std::span<const std::uint32_t> islands = coupled.group_of(cold.island);
        if (visited[islands.front()]) continue;
        visited[islands.front()] = true;
        groups.push_back(measured(sets.islands, def, islands));
    }
    return groups;
}

// Lowers levels until the groups are within the budget, or all are at the lowest level.
void distribute_budget(const IslandStore& islands, const SteppingState& stepping,
                       std::vector<CoupledGroup>& groups) {
    const auto spends = [&](const CoupledGroup& group) {
        const Island& island = islands.islands[group.islands.front()];
        return group.bodies * substeps_at(stepping, island, group.substep_level);
    };
    const auto harm = [&](const CoupledGroup& group) {
        const Island& island = islands.islands[group.islands.front()];
        return group.error * growth(stepping, island, group.substep_level - 1);
    };
    std::int64_t spent = 0;
    for (const CoupledGroup& group : groups) spent += spends(group);
    using Offer = std::pair<double, std::size_t>;
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
    const auto offer = [&](std::size_t k) {
        if (groups[k].substep_level > 0) offers.push({harm(groups[k]), k});
    };
    for (std::size_t k = 0; k < groups.size(); k++) offer(k);
    while (spent > stepping.def.substep_budget && !offers.empty()) {
        const std::size_t k = offers.top().second;
        offers.pop();
        spent -= spends(groups[k]);
        groups[k].substep_level--;
        spent += spends(groups[k]);
        offer(k);
    }
}

}  // namespace

void choose_substep_levels(StepContext& step) {
    WorldState& world = step.world;
    std::vector<std::uint32_t> changing;
    for (std::uint32_t i = 0; i < world.islands.ids.size(); i++) {
        if (!is_awake(world.islands, i) || !world.islands.islands[i].error.fresh) continue;
        choose_target_level(world, world.islands.islands[i]);
        if (world.islands.islands[i].error.target_level !=
            world.islands.islands[i].colour_set.batch)
            changing.push_back(i);
    }
    if (world.def.substep_budget == 0 && !changing.empty()) {
        const CoupledIslands coupled(world);
        for (const std::uint32_t i : changing)
            move(world, world.joints, measured(world.islands, world.def, coupled.group_of(i)));
    } else if (world.def.substep_budget > 0 && world.steps % tuning::budget_interval == 1) {
        const CoupledIslands coupled(world);
        std::vector<CoupledGroup> groups = find_active_groups(world, world.def, coupled);
        distribute_budget(world.islands, world, groups);
        for (const CoupledGroup& group : groups) move(world, world.joints, group);
    }
    auto& unknown = step.scratch.islands.unknown;
    unknown.fill(0);
    for (const BodyWarm& warm : world.bodies.awake) {
        if (!is_held(world.bodies.cold[warm.body])) continue;
        const Island& island = world.islands.islands[world.bodies.cold[warm.body].island];
        if (island.error.estimate == 0) unknown[index_of(island.colour_set)] = 1;
    }
}

}  // namespace jostle::physics
