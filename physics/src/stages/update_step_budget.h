// SPDX-License-Identifier: MIT
//
// The end of a step: sums up its work and, in a world with a budget, derives the overload level of
// the next step (state/overload_state.h). The level rises by one after a step of more work than the
// budget, so no step is ever truncated, and falls by one after many cheap steps in a row.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Computed from the step's own counters; independent of the number of threads.
std::int64_t step_work(const StepProfile& profile);

// Reads: the profile's counters, WorldDef::step_budget. Writes: StepProfile::work,
// WorldState::overload_level, and the impulses that warm-start the next step if its sub-steps have
// another length. Runs last, because events refer to the sub-steps of this step.
void update_step_budget(WorldState& world);

}  // namespace jostle::physics
