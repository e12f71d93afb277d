// SPDX-License-Identifier: MIT
//
// With a tolerance (WorldDef::tolerance), chooses the number of sub-steps of each island: the
// smallest of substeps_per_level that keeps its error, as measured by stages/solver/error_trial.h,
// within the tolerance. Levels rise immediately and fall with a delay, because contacts move
// between sets.
//
// With a budget (WorldDef::substep_budget) the requested sub-steps are reduced: the island whose
// error would be the smallest at a lower level gives way first. An island's level then no longer
// depends on that island alone.
//
// Reads: Island::error. Writes: Island::error, Island::colour_set, contacts, impulses. Leaves in
// scratch, for the solver: which colour sets have an island of unknown error.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

void choose_substep_levels(StepContext& step);

}  // namespace jostle::physics
