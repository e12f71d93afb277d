// SPDX-License-Identifier: MIT
#include "stages/prepare_islands.h"

#include <algorithm>

#include "jostle/physics/tuning.h"
#include "state/efforts.h"
#include "state/lanes.h"

namespace jostle::physics {
namespace {

// ---- effort ----

// What stands of each island: not what flies past or falls.
void measure_heights(WorldState& world, Vec3 up) {
    auto& extents = world.scratch.extents;
    extents.assign(world.islands.ids.size(), {});
    for (const BodyWarm& warm : world.bodies.awake) {
        const BodyCold& cold = world.bodies.cold[warm.body];
        if (cold.lanes == 0 || cold.island == none ||
            length_squared(warm.v) > tuning::standing_speed * tuning::standing_speed)
            continue;
        IslandExtent& extent = extents[cold.island];
        const double height = dot(up, warm.center);
        extent.low = minimum(extent.low, height);
        extent.high = maximum(extent.high, height);
        extent.thickness += 2 * cold.inner_radius;
        extent.bodies++;
    }
}

// How many bodies of the island's mean thickness lie upon each other, if they do.
double layers_of(const IslandExtent& extent) {
    if (extent.bodies < 2 || extent.thickness <= 0) return 1;
    return 1 + (extent.high - extent.low) * extent.bodies / extent.thickness;
}

// Whether one of the two dynamic bodies weighs a hundred times what it lies on.
bool is_overloaded(WorldState& world, const Contact& c, Vec3 up) {
    const double a = world.bodies.cold[c.body_a].mass, b = world.bodies.cold[c.body_b].mass;
    if (maximum(a, b) < tuning::heavy_ratio * minimum(a, b) || b == 0) return false;
    const double rise = dot(normal_of(place_of(world, c)), up);
    return (b > a ? rise : -rise) > 0.3;
}

bool has_overload(WorldState& world, const Island& island, Vec3 up) {
    for (std::uint32_t body = island.first; body != none;
         body = world.bodies.cold[body].island_next) {
        bool found = false;
        for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t index) {
            const Contact& c = world.contacts.contacts[index];
            if (c.body_a == body && c.colour >= 0 && c.touching)
                found = found || is_overloaded(world, c, up);
        });
        if (found) return true;
    }
    return false;
}

Effort need_of(WorldState& world, std::uint32_t index, Vec3 up) {
    const Island& island = world.islands.islands[index];
    if (island.uneven && has_overload(world, island, up)) return Effort::heavy;
    const double limit =
        island.effort == Effort::standard ? tuning::tall_layers : tuning::tall_layers_end;
    return layers_of(world.scratch.extents[index]) > limit ? Effort::tall : Effort::standard;
}

// Up at once; down when all that is tied to it has been content with less for a while.
void settle_effort(WorldState& world, std::uint32_t index, Vec3 up) {
    Island& island = world.islands.islands[index];
    const Effort need = need_of(world, index, up);
    if (need > island.effort) return set_effort(world, tied_islands(world, index), need);
    if (need == island.effort) {
        island.calm = 0;
        return;
    }
    if (island.calm < tuning::effort_patience && ++island.calm < tuning::effort_patience) return;
    const std::vector<std::uint32_t> tied = tied_islands(world, index);
    Effort most = need;
    for (const std::uint32_t i : tied) {
        if (world.islands.islands[i].calm < tuning::effort_patience) return;
        most = std::max(most, need_of(world, i, up));
    }
    set_effort(world, tied, most);
}

void choose_efforts(WorldState& world) {
    const Vec3 up = -normalized(world.def.gravity);
    measure_heights(world, up);
    for (std::uint32_t i = 0; i < world.islands.ids.size(); i++)
        if (world.islands.ids.alive(i) && !world.islands.islands[i].asleep)
            settle_effort(world, i, up);
}

// ---- loads that went ----

void forget_lost_loads(WorldState& world) {
    world.islands.some_lost = false;
    for (Island& island : world.islands.islands) {
        if (island.kept_load < tuning::noticed_load && !island.asleep)
            scale_loads(world, island, static_cast<float>(island.kept_load));
        island.kept_load = 1;
    }
}

}  // namespace

Skipped prepare_islands(StepContext& step) {
    WorldState& world = step.world;
    if (world.bodies.awake.empty()) return nobody_awake;
    // The second step is the first that knows what hangs together.
    const bool look = world.steps % tuning::effort_interval == 1 && world.def.gravity != Vec3{};
    if (!look && !world.islands.some_lost) return "islands are looked at in every eighth step";
    if (world.islands.some_lost) forget_lost_loads(world);
    if (look) choose_efforts(world);
    return ran;
}

}  // namespace jostle::physics
