// SPDX-License-Identifier: MIT
//
// Groups of bodies that joints tie together and nothing touches. They are solved directly, apart
// from the solver's colours and levels: constraints/direct/direct_group.h.
//
// Reads: islands, bodies and joints; the sub-steps of an island's tier. Writes: what joints carry
// and report. Leaves in scratch: which awake bodies are in a group, and how they move, for
// solve_constraints and integrate_free.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Finds the groups of this step: islands with joints of kinds that they know, none of whose bodies
// has a contact. Before solve_constraints() sorts out the others.
void find_joint_groups(StepContext& step);
// Moves them through the step. Leaves motions for integrate_free, and what acted in the joints.
void solve_joint_groups(StepContext& step);

}  // namespace jostle::physics
