// SPDX-License-Identifier: MIT
//
// With a tolerance (WorldDef::tolerance), how many sub-steps each island takes: the fewest of
// substeps_per_level with which its error, as stages/solver/error_trial.h measured it, keeps to the
// tolerance. Finer at once, coarser with some patience: contacts move from set to set.
//
// With a budget (WorldDef::substep_budget) what islands want is dealt out: the one that a coarser
// rung would harm least, by the error it would have, gives in first. An island alone then no longer
// decides what it gets.
//
// Reads: Island::error. Writes: it, Island::colour_set, contacts, impulses. Leaves in scratch, for
// the solver: which colour sets hold an island of unknown error.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

void choose_substep_levels(StepContext& step);

}  // namespace jostle::physics
