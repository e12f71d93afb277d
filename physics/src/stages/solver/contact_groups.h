// SPDX-License-Identifier: MIT
//
// The islands of SolverTier::direct, whose contacts are solved together
// (constraints/contact_group).
#pragma once

#include "physics/src/stages/solver/solve_task.h"
#include "physics/src/stages/solver/solver_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// One group per set of bodies that manifolds connect, whether they touch yet or not. Call after the
// bodies of the task are prepared.
void find_contact_groups(StepContext& step, const SolverTask& task, ContactGroups& groups);

}  // namespace jostle::physics
