// SPDX-License-Identifier: MIT
//
// The sub-step loop over colours: velocities from forces and contacts, motion from velocities.
// Leaves its result in the hot records.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped solve_constraints(StepContext& step);

}  // namespace jostle::physics
