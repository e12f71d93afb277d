// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "jostle/physics/world.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/joint_graph.h"
#include "physics/src/world/checks.h"

namespace jostle::physics {
namespace {

IslandSubsteps describe_island(const WorldState& world, const Island& island) {
    const ColourSetKey set = island.colour_set;
    IslandSubsteps result{.body = body_id(world.bodies, island.first),
                          .bodies = static_cast<int>(island.bodies),
                          .substeps = substeps_of(set, world),
                          .error = island.error.estimate};
    result.target_substeps = controls_error(world.def)
                                 ? substeps_of({set.tier, island.error.target_level}, world)
                                 : result.substeps;
    return result;
}

// True if a contact or joint is counted at this body: its first dynamic body.
bool is_counted_at(const BodyStore& bodies, std::uint32_t body, std::uint32_t a, std::uint32_t b) {
    return (is_dynamic(bodies, a) ? a : b) == body;
}

void count_at(const WorldState& world, std::uint32_t body, IslandSubsteps& result) {
    const BodyCold& cold = world.bodies.cold[body];
    result.body = std::min(result.body, body_id(world.bodies, body));
    for_each_contact(world.contacts, cold, [&](std::uint32_t index) {
        const Contact& c = world.contacts.contacts[index];
        if (c.colour >= 0 && c.touching && is_counted_at(world.bodies, body, c.body_a, c.body_b))
            result.contacts++;
    });
    for_each_joint(world.joints, cold, [&](std::uint32_t index) {
        const Joint& j = world.joints.joints[index];
        if (is_counted_at(world.bodies, body, j.body_a, j.body_b)) result.joints++;
    });
}

}  // namespace

std::vector<IslandSubsteps> World::island_substeps() const {
    const WorldState& world = *state_;
    const std::vector<std::uint32_t>& direct = scratch_->solver.groups.active;
    std::map<std::uint32_t, IslandSubsteps> found;
    for (const BodyWarm& warm : world.bodies.awake) {
        const BodyCold& cold = world.bodies.cold[warm.body];
        if (cold.type != BodyType::dynamic || cold.asleep_in_place) continue;
        const Island& island = world.islands.islands[cold.island];
        auto& result = found.try_emplace(cold.island, describe_island(world, island)).first->second;
        count_at(world, warm.body, result);
        result.direct = std::binary_search(direct.begin(), direct.end(), cold.island);
    }
    std::vector<IslandSubsteps> results;
    for (const auto& [island, result] : found)
        if (result.contacts + result.joints > 0) results.push_back(result);
    std::sort(results.begin(), results.end(),
              [](const IslandSubsteps& x, const IslandSubsteps& y) { return x.body < y.body; });
    return results;
}

}  // namespace jostle::physics
