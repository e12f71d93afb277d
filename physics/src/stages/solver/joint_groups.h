// SPDX-License-Identifier: MIT
//
// Groups of bodies connected by joints and without contacts. They are solved directly
// (constraints/direct/direct_group.h), separately from the solver's colours and levels.
//
// Reads: islands, bodies and joints; the sub-steps of an island's tier. Writes: impulses and loads
// of joints. Leaves in scratch: the awake bodies in groups and their motions, for solve_constraints
// and integrate_free.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Finds the groups of this step: islands with supported joint kinds whose bodies have no contacts.
// Call before solve_constraints() classifies the other bodies.
void find_joint_groups(StepContext& step);
// Advances the groups through the step. Leaves motions for integrate_free, and writes the joint
// loads.
void solve_joint_groups(StepContext& step);

}  // namespace jostle::physics
