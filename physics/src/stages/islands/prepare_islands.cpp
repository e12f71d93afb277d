// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <algorithm>
#include <optional>
#include <span>

#include "jostle/base/check.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/islands/island_stages.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/island_tiers.h"
#include "physics/src/state/islands.h"

namespace jostle::physics {
namespace {

// ---- tier ----

// A faster body is falling.
bool stands(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity) {
    const double most =
        tuning::standing_speed * speed_scale(cold.radius, gravity_ratio_squared(gravity));
    return length_squared(warm.v) <= most * most;
}

// Measures the standing part of each island, without bodies that fly past or fall.
void measure_extents(const BodyStore& bodies, const IslandStore& islands, IslandScratch& scratch,
                     Vec3 gravity) {
    const Vec3 up = -normalized(gravity);
    std::vector<IslandExtent>& extents = scratch.extents;
    extents.resize(islands.ids.size());
    for (const std::uint32_t i : scratch.awake) extents[i] = {};
    const Vec3 east = normalized(cross(up, absolute(up.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}));
    const Vec3 north = cross(east, up);
    for (const BodyWarm& warm : bodies.awake) {
        const BodyCold& cold = bodies.cold[warm.body];
        if (cold.constraints == 0 || cold.island == none || !stands(warm, cold, gravity)) continue;
        ASSERT(cold.island < extents.size());
        IslandExtent& extent = extents[cold.island];
        if (extent.bodies++ == 0) extent.first = warm.center;
        const Vec3 from = warm.center - extent.first;
        const double height = dot(up, from), x = dot(east, from), y = dot(north, from);
        extent.low = minimum(extent.low, height);
        extent.high = maximum(extent.high, height);
        extent.thickness += 2 * cold.inner_radius;
        extent.x += x, extent.y += y;
        extent.xx += x * x, extent.xy += x * y, extent.yy += y * y;
    }
}

// Horizontal extent in the narrowest direction, m: the depth of a box with the same variance.
double depth_of(const IslandExtent& e) {
    ASSERT(e.bodies > 0);
    const double n = e.bodies, xx = e.xx / n - e.x * e.x / (n * n),
                 xy = e.xy / n - e.x * e.y / (n * n), yy = e.yy / n - e.y * e.y / (n * n);
    const double half = 0.5 * (xx - yy);
    const double least = 0.5 * (xx + yy) - square_root(half * half + xy * xy);
    return square_root(12 * maximum(least, 0)) + e.thickness / n;
}

// A stack, a tower or a wall: a small base for its height. A pile does not lean.
bool is_slender(const IslandExtent& e) {
    return e.bodies > 1 && e.high - e.low > tuning::slenderness * depth_of(e);
}

// Number of layers if its bodies of mean thickness are stacked.
double layers_of(const IslandExtent& e) {
    return 1 + (e.high - e.low) * e.bodies / maximum(e.thickness, 1e-9);
}

SolverTier need_of(ContactGraph& stores, const std::vector<IslandExtent>& extents,
                   std::uint32_t index, Vec3 up) {
    const Island& island = stores.islands.islands[index];
    ASSERT(stores.islands.ids.alive(index) && !island.asleep);
    const IslandExtent& extent = extents[index];
    if (extent.solved_directly) return SolverTier::direct;
    if (island.uneven && has_heavy_load(stores, island, up)) return SolverTier::heavy;
    if (!is_slender(extent)) {
        const auto bodies = static_cast<int>(island.bodies);
        if (layers_of(extent) <= tuning::flat_layers)
            return extent.bodies == bodies ? SolverTier::flat : SolverTier::low;
        return 2 * extent.bodies > bodies ? SolverTier::pile : SolverTier::low;
    }
    const double limit =
        island.colour_set.tier < SolverTier::tall ? tuning::tall_layers : tuning::tall_layers_end;
    return layers_of(extent) > limit ? SolverTier::tall : SolverTier::slender;
}

// The common tier of coupled islands: the highest required tier if that is above slender, otherwise
// the tier of the majority of the bodies.
SolverTier common_need(ContactGraph& stores, std::vector<IslandExtent>& extents,
                       std::span<const std::uint32_t> coupled, Vec3 up) {
    SolverTier most = SolverTier::flat, max_low = SolverTier::flat;
    std::uint32_t low = 0, slender = 0;
    for (const std::uint32_t i : coupled) {
        const SolverTier need = need_of(stores, extents, i, up);
        most = std::max(most, need);
        if (need <= SolverTier::pile) max_low = std::max(max_low, need);
        (need <= SolverTier::pile ? low : slender) += stores.islands.islands[i].bodies;
        extents[i].tier_chosen = true;
    }
    if (most > SolverTier::slender) return most;
    return slender > low ? SolverTier::slender : max_low;
}

// Raises the tier immediately. Lowers it after all coupled islands have required less for a while.
void choose_tier(ContactGraph& stores, JointStore& joints, std::vector<IslandExtent>& extents,
                 std::optional<CoupledIslands>& all_coupled, std::uint32_t index, Vec3 up) {
    Island& island = stores.islands.islands[index];
    const SolverTier need = need_of(stores, extents, index, up);
    island.calm = need < island.colour_set.tier
                      ? std::min<std::uint8_t>(island.calm + 1, tuning::tier_patience)
                      : 0;
    if (need == island.colour_set.tier || extents[index].tier_chosen) return;
    if (need < island.colour_set.tier && island.calm < tuning::tier_patience) return;
    if (!all_coupled) all_coupled.emplace(stores);
    const std::span<const std::uint32_t> coupled = all_coupled->group_of(index);
    const SolverTier common = common_need(stores, extents, coupled, up);
    // Weighted by bodies: new bodies that keep falling onto a pile reset the counter of their own
    // islands.
    std::uint32_t calm = 0, all = 0;
    for (const std::uint32_t i : coupled) {
        const Island& other = stores.islands.islands[i];
        all += other.bodies;
        if (other.calm >= tuning::tier_patience) calm += other.bodies;
    }
    if (common > island.colour_set.tier || 2 * calm > all)
        move_to_set(stores, joints, coupled, {common, island.colour_set.batch});
}

// Returns whether loads can be uneven: without a heavier body, equal ones only add up layer by
// layer.
bool have_different_masses(const BodyStore& bodies) {
    double lightest = 1e300, heaviest = 0;
    for (const BodyWarm& warm : bodies.awake) {
        const BodyCold& cold = bodies.cold[warm.body];
        if (cold.constraints == 0 || cold.island == none) continue;
        lightest = minimum(lightest, cold.mass);
        heaviest = maximum(heaviest, cold.mass);
    }
    return heaviest > 1.5 * lightest;
}

// Finds the islands for SolverTier::direct.
void find_direct_islands(ContactGraph& stores, IslandScratch& scratch,
                         std::optional<CoupledIslands>& all_coupled, Vec3 up) {
    if (stores.def.planar || !have_different_masses(stores.bodies)) return;
    if (!all_coupled) all_coupled.emplace(stores);
    for (const std::uint32_t i : scratch.awake) {
        if (stores.islands.islands[i].bodies > tuning::max_group_bodies) continue;
        const std::span<const std::uint32_t> coupled = all_coupled->group_of(i);
        if (coupled.front() != i || !may_be_solved_directly(stores, coupled) ||
            !mostly_stand(stores, coupled))
            continue;
        if (largest_load_ratio(stores, coupled, up) < tuning::direct_load_ratio) continue;
        for (const std::uint32_t member : coupled) scratch.extents[member].solved_directly = true;
    }
}

void choose_tiers(ContactGraph& stores, JointStore& joints, IslandScratch& scratch) {
    const Vec3 up = -normalized(stores.def.gravity);
    find_awake_islands(stores, scratch.awake);
    measure_extents(stores.bodies, stores.islands, scratch, stores.def.gravity);
    std::optional<CoupledIslands>
        coupled;  // built on first use; moves to other sets do not invalidate it
    find_direct_islands(stores, scratch, coupled, up);
    for (const std::uint32_t i : scratch.awake)
        choose_tier(stores, joints, scratch.extents, coupled, i, up);
}

// ---- lost loads ----

void scale_lost_loads(ContactGraph& stores) {
    stores.islands.some_lost = false;
    for (std::uint32_t i = 0; i < stores.islands.ids.size(); i++) {
        // Loading a world does not validate the records of islands that do not exist.
        if (!stores.islands.ids.alive(i)) continue;
        Island& island = stores.islands.islands[i];
        if (island.remaining_load < tuning::noticed_load && !island.asleep)
            scale_warm_start(stores, island, static_cast<float>(island.remaining_load));
        island.remaining_load = 1;
    }
}

}  // namespace

Skipped prepare_islands(StepContext& step) {
    WorldState& world = step.world;
    if (world.bodies.awake.empty()) return no_awake_bodies;
    leave_direct_tier(world, world.joints);
    // The second step is the first with known islands.
    const bool update_tiers = world.steps % tuning::tier_interval == 1;
    const bool update_sizes = needs_size_levels(step);
    if (!update_tiers && !world.islands.some_lost && !update_sizes && !controls_error(world.def))
        return "islands are updated every eighth step";
    if (world.islands.some_lost) scale_lost_loads(world);
    if (update_tiers && world.def.gravity != Vec3{})
        choose_tiers(world, world.joints, step.scratch.islands);
    if (update_sizes) choose_size_levels(step);
    if (controls_error(world.def))
        choose_substep_levels(step);
    else if (!world.size_levels && world.steps % tuning::batch_interval == 1)
        assign_batches(step);
    if (world.steps % tuning::sort_interval == 1) sort_constraints(step);
    return ran;
}

}  // namespace jostle::physics
