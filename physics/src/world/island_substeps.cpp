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

IslandSubsteps effort_of(const WorldState& world, const Island& island) {
    const ColourSetKey set = island.colour_set;
    IslandSubsteps effort{.body = body_id(world, island.first),
                        .bodies = static_cast<int>(island.bodies),
                        .substeps = substeps_of(set, world),
                        .error = island.error.estimate};
    effort.wanted_substeps = controls_error(world.def)
                                 ? substeps_of({set.tier, island.error.wanted}, world)
                                 : effort.substeps;
    return effort;
}

// Counted at its first dynamic body.
bool counts_here(const WorldState& world, std::uint32_t body, std::uint32_t a, std::uint32_t b) {
    return (is_dynamic(world, a) ? a : b) == body;
}

void count_at(const WorldState& world, std::uint32_t body, IslandSubsteps& effort) {
    const BodyCold& cold = world.bodies.cold[body];
    effort.body = std::min(effort.body, body_id(world, body));
    for_each_contact(world.contacts, cold, [&](std::uint32_t index) {
        const Contact& c = world.contacts.contacts[index];
        if (c.colour >= 0 && c.touching && counts_here(world, body, c.body_a, c.body_b))
            effort.contacts++;
    });
    for_each_joint(world.joints, cold, [&](std::uint32_t index) {
        const Joint& j = world.joints.joints[index];
        if (counts_here(world, body, j.body_a, j.body_b)) effort.joints++;
    });
}

}  // namespace

std::vector<IslandSubsteps> World::island_efforts() const {
    const WorldState& world = *state_;
    const std::vector<std::uint32_t>& direct = scratch_->solver.groups.active;
    std::map<std::uint32_t, IslandSubsteps> found;
    for (const BodyWarm& warm : world.bodies.awake) {
        const BodyCold& cold = world.bodies.cold[warm.body];
        if (cold.type != BodyType::dynamic || cold.asleep_in_place) continue;
        const Island& island = world.islands.islands[cold.island];
        auto& effort = found.try_emplace(cold.island, effort_of(world, island)).first->second;
        count_at(world, warm.body, effort);
        effort.direct = std::binary_search(direct.begin(), direct.end(), cold.island);
    }
    std::vector<IslandSubsteps> efforts;
    for (const auto& [island, effort] : found)
        if (effort.contacts + effort.joints > 0) efforts.push_back(effort);
    std::sort(efforts.begin(), efforts.end(),
              [](const IslandSubsteps& x, const IslandSubsteps& y) { return x.body < y.body; });
    return efforts;
}

}  // namespace jostle::physics
