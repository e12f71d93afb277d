// SPDX-License-Identifier: MIT
#include "physics/src/stages/islands/island_stages.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/island_tiers.h"

namespace jostle::physics {
namespace {

using BatchLoads = std::array<std::uint32_t, batch_count>;

struct Work {
    BatchLoads loads{}, lightest{};      // by batch; the lightest island of each
    std::uint32_t all = 0, largest = 0;  // largest: of a single island
};

// Estimates the work of an island: its bodies and their manifolds (counted twice between two
// bodies), and approximately its joints.
std::array<Work, tier_count> weigh_islands(const BodyStore& bodies, const IslandStore& islands,
                                           std::vector<std::uint32_t>& weights) {
    weights.assign(islands.ids.size(), 0);
    for (const BodyWarm& warm : bodies.awake) {
        const BodyCold& cold = bodies.cold[warm.body];
        if (cold.island == none || cold.asleep_in_place) continue;
        const std::uint32_t jointed = cold.first_joint != none ? 2 : 0;
        if (cold.constraints > 0 || jointed > 0)
            weights[cold.island] += 1 + cold.constraints + jointed;
    }
    std::array<Work, tier_count> works;
    for (std::uint32_t i = 0; i < weights.size(); i++) {
        if (weights[i] == 0) continue;
        ASSERT(islands.ids.alive(i) && !islands.islands[i].asleep);
        const ColourSetKey set = islands.islands[i].colour_set;
        Work& work = works[index_of(set.tier)];
        std::uint32_t& lightest = work.lightest[set.batch];
        lightest = work.loads[set.batch] == 0 ? weights[i] : std::min(lightest, weights[i]);
        work.loads[set.batch] += weights[i];
        work.all += weights[i];
        work.largest = std::max(work.largest, weights[i]);
    }
    return works;
}

// The number of batches that pays off, a power of two so that two threads get equal numbers.
std::uint32_t batches_for(std::uint32_t weight) {
    std::uint32_t batches = 1;
    while (batches < batch_count && weight >= 2 * batches * tuning::min_batch) batches *= 2;
    return batches;
}

// Returns whether the fullest batch has more than its share and contains an island that would not
// make the emptiest batch fuller than the fullest one is now.
bool is_unequal(const Work& work) {
    const std::uint32_t batches = batches_for(work.all);
    if (batches < 2 || 2 * work.largest > work.all) return false;
    const auto first = work.loads.begin();
    const auto most = std::max_element(first, work.loads.end());
    const std::uint32_t gap = *most - *std::min_element(first, first + batches);
    return *most * batches > tuning::batch_unequal * work.all &&
           work.lightest[static_cast<std::size_t>(most - first)] < tuning::batch_unequal * gap / 2;
}

// Islands together with all islands coupled to them by manifolds.
struct Group {
    std::span<const std::uint32_t> islands;
    std::uint32_t weight = 0;
    bool stays = false;
};

std::vector<Group> find_groups(const IslandStore& store, const CoupledIslands& coupled,
                               const std::vector<std::uint32_t>& weights, SolverTier tier) {
    std::vector<Group> groups;
    std::vector<bool> visited(weights.size(), false);  // by first island of a group
    for (std::uint32_t i = 0; i < weights.size(); i++) {
        if (weights[i] == 0 || store.islands[i].colour_set.tier != tier) continue;
        const std::span<const std::uint32_t> islands = coupled.group_of(i);
        if (visited[islands.front()]) continue;
        visited[islands.front()] = true;
        Group& group = groups.emplace_back(Group{islands});
        for (const std::uint32_t island : group.islands) group.weight += weights[island];
    }
    return groups;
}

// The heaviest groups remain in their batch while there is space. The others fill the batches in
// order, so that neighbours in the body lists stay together.
void assign(ContactGraph& stores, JointStore& joints, const CoupledIslands& coupled,
            const std::vector<std::uint32_t>& weights, SolverTier tier, const Work& work) {
    std::vector<Group> groups = find_groups(stores.islands, coupled, weights, tier);
    const std::uint32_t batches = batches_for(work.all), fair = work.all / batches;
    std::vector<std::size_t> heaviest(groups.size());
    for (std::size_t k = 0; k < groups.size(); k++) heaviest[k] = k;
    std::stable_sort(heaviest.begin(), heaviest.end(), [&](std::size_t a, std::size_t b) {
        return groups[a].weight > groups[b].weight;
    });
    BatchLoads loads{};
    for (const std::size_t k : heaviest) {
        Group& group = groups[k];
        const std::uint8_t batch = stores.islands.islands[group.islands.front()].colour_set.batch;
        group.stays = batch < batches && (loads[batch] == 0 || loads[batch] + group.weight <= fair);
        if (group.stays) loads[batch] += group.weight;
    }
    ASSERT(batches >= 1 && batches <= batch_count);
    std::uint8_t to = 0;
    for (const Group& group : groups) {
        if (group.stays) continue;
        while (to + 1u < batches && loads[to] + group.weight / 2 > fair) to++;
        loads[to] += group.weight;
        move_to_set(stores, joints, group.islands, {tier, to});
    }
}

}  // namespace

void assign_batches(StepContext& step) {
    WorldState& world = step.world;
    std::vector<std::uint32_t>& weights = step.scratch.islands.weights;
    const std::array<Work, tier_count> works = weigh_islands(world.bodies, world.islands, weights);
    std::optional<CoupledIslands> coupled;
    for (const SolverTier tier : all_tiers) {
        const Work& work = works[index_of(tier)];
        if (!is_unequal(work)) continue;
        if (!coupled) coupled.emplace(world);
        assign(world, world.joints, *coupled, weights, tier, work);
    }
}

}  // namespace jostle::physics
