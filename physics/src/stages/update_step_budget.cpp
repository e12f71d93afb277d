// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/impulse_scale.h"

namespace jostle::physics {
namespace {

OverloadState next_overload_level(OverloadState overload_level, std::int64_t work,
                                  std::int64_t budget) {
    ASSERT(budget > 0 && overload_level.level <= max_overload_level);
    if (work > budget) {
        overload_level.easy = 0;
        if (overload_level.level < max_overload_level) overload_level.level++;
        return overload_level;
    }
    const bool easy =
        static_cast<double>(work) < tuning::cheap_step_ratio * static_cast<double>(budget);
    overload_level.easy =
        easy && overload_level.level > 0 ? static_cast<std::uint8_t>(overload_level.easy + 1) : 0;
    if (overload_level.easy < tuning::overload_patience) return overload_level;
    return {.level = static_cast<std::uint8_t>(overload_level.level - 1)};
}

// Sleeping bodies are updated when they wake.
void update_overload_level(ContactGraph& stores, JointStore& joints, OverloadState to) {
    std::array<double, solved_set_count> scale{};
    for (const SolverTier tier : all_tiers)
        for (std::uint8_t batch = 0; batch < batch_count; batch++) {
            const ColourSetKey set{tier, batch};
            scale[index_of(set)] = substeps_of(set, stores);
        }
    const bool other_substeps = halves_substeps(stores.overload_level) != halves_substeps(to);
    stores.overload_level = to;
    if (!other_substeps) return;
    for (const SolverTier tier : all_tiers)
        for (std::uint8_t batch = 0; batch < batch_count; batch++) {
            const ColourSetKey set{tier, batch};
            scale[index_of(set)] /= substeps_of(set, stores);
        }
    scale_awake(stores, joints, scale);
}

}  // namespace

std::int64_t step_work(const StepProfile& profile) {
    return (tuning::body_work * profile.bodies_awake +
            tuning::narrow_phase_work * profile.pairs_checked +
            tuning::composite_work * profile.composites_checked +
            tuning::contact_work * profile.contact_substeps +
            tuning::joint_work * profile.joint_substeps +
            tuning::direct_block_work * profile.direct_work + tuning::sweep_work * profile.sweeps +
            tuning::impact_work * profile.impacts) /
               tuning::work_unit +
           profile.module_work;
}

void update_step_budget(WorldState& world) {
    world.profile.work = step_work(world.profile);
    if (world.def.step_budget == 0) return;
    update_overload_level(
        world, world.joints,
        next_overload_level(world.overload_level, world.profile.work, world.def.step_budget));
}

}  // namespace jostle::physics
