// SPDX-License-Identifier: MIT
//
// The end of a step: what it did is added up, and in a world with a budget the strain of the next
// step follows from that (state/overload_state.h). It rises by one after a step of more work than
// the budget, so no step is ever cut short, and falls by one after many cheap ones in a row.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Of the step's own counters; the same for any number of threads.
std::int64_t step_work(const StepProfile& profile);

// Reads: the profile's counters, WorldDef::step_budget. Writes: StepProfile::work, Strain, and the
// impulses that warm-start the next step where its sub-steps are of another length. After all else:
// events tell of the sub-steps that were.
void update_step_budget(WorldState& world);

}  // namespace jostle::physics
