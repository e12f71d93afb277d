// SPDX-License-Identifier: MIT
//
// The two points of the step at which bodies wake: before the solve, and after impacts. All stages
// file requests (state/wake_requests.h); bodies wake nowhere else.
//
// Read and clear: WorldState::wake_requests. Write: body sets, islands, manifolds of sleeping
// islands back into the constraint graph, wake events. Leave nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Files requests for disturbed bodies that sleep in place, then wakes all requested bodies: those
// with new neighbours, new contacts or ended contacts.
Skipped wake_before_solve(StepContext& step);

// Wakes sleeping bodies that were hit by impacts or have lost a contact since.
Skipped wake_after_impacts(StepContext& step);

}  // namespace jostle::physics
