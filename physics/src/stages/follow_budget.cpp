// SPDX-License-Identifier: MIT
#include "physics/src/stages/follow_budget.h"

#include "physics/src/foundation/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/impulse_scale.h"

namespace jostle::physics {
namespace {

OverloadState next_strain(OverloadState strain, std::int64_t work, std::int64_t budget) {
    ASSERT(budget > 0 && strain.level <= most_strain);
    if (work > budget) {
        strain.easy = 0;
        if (strain.level < most_strain) strain.level++;
        return strain;
    }
    const bool easy = static_cast<double>(work) < tuning::easy_work * static_cast<double>(budget);
    strain.easy = easy && strain.level > 0 ? static_cast<std::uint8_t>(strain.easy + 1) : 0;
    if (strain.easy < tuning::strain_patience) return strain;
    return {.level = static_cast<std::uint8_t>(strain.level - 1)};
}

// What sleeps follows when it wakes.
void change_strain(WorldState& world, OverloadState to) {
    std::array<double, solved_set_count> scale{};
    for (const SolverTier tier : all_tiers)
        for (std::uint8_t batch = 0; batch < batch_count; batch++) {
            const ColourSetKey set{tier, batch};
            scale[index_of(set)] = substeps_of(set, world);
        }
    const bool other_substeps = halves_substeps(world.strain) != halves_substeps(to);
    world.strain = to;
    if (!other_substeps) return;
    for (const SolverTier tier : all_tiers)
        for (std::uint8_t batch = 0; batch < batch_count; batch++) {
            const ColourSetKey set{tier, batch};
            scale[index_of(set)] /= substeps_of(set, world);
        }
    scale_awake(world, scale);
}

}  // namespace

std::int64_t work_of(const StepProfile& profile) {
    return (tuning::body_work * profile.bodies_awake + tuning::look_work * profile.pairs_checked +
            tuning::composite_work * profile.composites_checked +
            tuning::contact_work * profile.contact_substeps +
            tuning::joint_work * profile.joint_substeps + tuning::sweep_work * profile.sweeps +
            tuning::impact_work * profile.impacts) /
           tuning::work_unit;
}

void follow_budget(WorldState& world) {
    world.profile.work = work_of(world.profile);
    if (world.def.step_budget == 0) return;
    change_strain(world, next_strain(world.strain, world.profile.work, world.def.step_budget));
}

}  // namespace jostle::physics
