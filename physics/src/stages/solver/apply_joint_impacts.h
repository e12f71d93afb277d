// SPDX-License-Identifier: MIT
//
// Bounces of bodies that hang on joints. The sweep would let them go on without their joints
// (stages/continuous/ccd_policy.h), so the solver has them, and before its sub-steps they are
// resolved here: pair after pair, the hardest first, as one hands a push on to the next. All at
// once a row of balls on threads would share it.
//
// Of pairs that move both: what fixed and kinematic bodies give back depends on how far one falls
// until then, which constraints/contact_kernel.h sees to.
#pragma once

#include <span>

#include "physics/src/constraints/contact_passes.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Reads: manifolds of a task, hot records as prepared. Writes: velocities of hot records.
void apply_joint_impacts(StepContext& step, std::span<const ColourRun> runs);

}  // namespace jostle::physics
