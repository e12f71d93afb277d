// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/islands/island_stages.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/island_tiers.h"
#include "physics/src/state/islands.h"

namespace jostle::physics {
namespace {

// The lowest level whose sub-steps are short enough for a body of this size, in steps of dt.
std::uint8_t level_for(double size, Vec3 gravity, double dt) {
    if (gravity == Vec3{} || !may_need_size_level(size, gravity)) return 0;
    const double rate =
        time_scale_ratio(size, gravity_ratio_squared(gravity)) * dt * tuning::usual_rate;
    std::uint8_t level = 0;
    while (level + 1 < batch_count && rate > tuning::size_level_reserve * substeps_per_size[level])
        level++;
    return level;
}

constexpr double none_smaller = 1e300;  // m

// Batches that share work become level 0.
void begin_levels(WorldState& world) {
    const CoupledIslands coupled(world);
    for (std::uint32_t i = 0; i < world.islands.ids.size(); i++) {
        if (!world.islands.ids.alive(i)) continue;
        Island& island = world.islands.islands[i];
        if (island.asleep)
            island.colour_set.batch = 0;
        else if (island.colour_set.batch != 0)
            move_to_set(world, world.joints, coupled.group_of(i), {island.colour_set.tier, 0});
    }
    world.size_levels = true;
}

// By island, over the awake bodies with contacts.
void measure_smallest(const WorldState& world, std::vector<double>& smallest) {
    smallest.assign(world.islands.ids.size(), none_smaller);
    for (const BodyWarm& warm : world.bodies.awake) {
        const BodyCold& cold = world.bodies.cold[warm.body];
        if (cold.constraints == 0 || cold.island == none) continue;
        smallest[cold.island] = minimum(smallest[cold.island], cold.radius);
    }
}

bool may_fall(const WorldState& world) {
    return world.size_levels && world.steps % tuning::size_level_interval == 1;
}

}  // namespace

bool needs_size_levels(const StepContext& step) {
    const WorldState& world = step.world;
    if (controls_error(world.def)) return false;
    const SmallContacts small = world.islands.small;
    return small == SmallContacts::began ||
           (small == SmallContacts::known &&
            (step.dt > world.islands.levels_dt || may_fall(world)));
}

void choose_size_levels(StepContext& step) {
    WorldState& world = step.world;
    world.islands.levels_dt = step.dt;
    std::vector<double>& smallest = step.scratch.islands.smallest;
    measure_smallest(world, smallest);
    const bool some_small = std::any_of(smallest.begin(), smallest.end(), [&](double size) {
        return may_need_size_level(size, world.def.gravity);
    });
    world.islands.small =
        some_small || world.size_levels ? SmallContacts::known : SmallContacts::absent;
    const auto required = [&](std::uint32_t island) {
        return level_for(smallest[island], world.def.gravity, step.dt);
    };
    std::vector<std::uint32_t>& awake = step.scratch.islands.awake;
    find_awake_islands(world, awake);
    if (!world.size_levels) {
        if (std::none_of(awake.begin(), awake.end(),
                         [&](std::uint32_t i) { return required(i) > 0; }))
            return;
        begin_levels(world);
    }
    // Contacts move between sets, so levels fall rarely.
    const bool falls = may_fall(world);
    const CoupledIslands coupled(world);
    for (const std::uint32_t i : awake) {
        const std::span<const std::uint32_t> group = coupled.group_of(i);
        if (group.front() != i) continue;
        std::uint8_t level = 0;
        for (const std::uint32_t island : group) level = std::max(level, required(island));
        const ColourSetKey set = world.islands.islands[i].colour_set;
        ASSERT(set.batch < batch_count);
        if (level > set.batch || (falls && level < set.batch))
            move_to_set(world, world.joints, group, {set.tier, level});
    }
}

}  // namespace jostle::physics
