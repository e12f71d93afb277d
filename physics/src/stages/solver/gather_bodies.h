// SPDX-License-Identifier: MIT
//
// Distributes the awake bodies of a step: solved bodies by the colour set of their island,
// kinematic bodies that the solver reads, and free bodies. Part of solve_constraints.
// Single-threaded.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Reads: awake bodies, Island::colour_set, JointGroupScratch::grouped. Leaves in scratch:
// SolverScratch::bodies, jointed, kinematic, free and set_of.
void gather_bodies(StepContext& step);

// Writes the body and sub-step counters of the profile. Call after gather_bodies().
void count_solver_work(StepContext& step);

}  // namespace jostle::physics
