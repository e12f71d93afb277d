// SPDX-License-Identifier: MIT
//
// The two points of the step at which bodies wake: before anything is solved, and after impacts
// between steps. All stages file requests (state/wake_requests.h); nobody wakes anybody elsewhere.
//
// Read: WorldState::wake_requests, which are empty then. Write: body sets, islands, manifolds of
// sleeping islands back into the constraint graph, wake events. Leave nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Files what disturbs bodies that sleep in place, then wakes all of whom requests speak: those with
// new neighbours, with contacts that begin, with touches that ended.
Skipped wake_before_solve(StepContext& step);

// Wakes whom impacts met asleep, and what lost a touch since.
Skipped wake_after_impacts(StepContext& step);

}  // namespace jostle::physics
