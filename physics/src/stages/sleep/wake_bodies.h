// SPDX-License-Identifier: MIT
//
// The two points of the step at which bodies wake: before anything is solved, and after impacts
// between steps. All stages file requests (state/wake_requests.h); nobody wakes anybody elsewhere.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

// Files what disturbs bodies that sleep in place, and wakes all who are to wake: by new neighbours,
// by contacts that begin, by touches that ended.
Skipped wake_before_solve(StepContext& step);

// Wakes whom impacts met asleep, and what lost a touch since.
Skipped wake_after_impacts(StepContext& step);

}  // namespace jostle::physics
