// SPDX-License-Identifier: MIT
//
// Bounces of bodies with joints. A sweep would move them without their joints
// (stages/continuous/ccd_policy.h), so the solver handles them. This function resolves them before
// the sub-steps: pair by pair, the hardest first, so that an impulse is passed on from body to
// body. Resolved simultaneously, a row of balls on threads (Newton's cradle) would share it.
//
// Only for pairs of two movable bodies. The rebound from static and kinematic bodies depends on the
// fall until the contact, which constraints/contact_kernel.h handles.
#pragma once

#include <span>

#include "physics/src/constraints/contact_passes.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Reads: manifolds of a task, prepared hot records. Writes: velocities of hot records.
void apply_joint_impacts(StepContext& step, std::span<const ColourRun> runs);

}  // namespace jostle::physics
