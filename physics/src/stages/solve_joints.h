// SPDX-License-Identifier: MIT
//
// The joint passes of solve_constraints: beside the contacts, in order of joints.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

// Finds the joints of the islands of one effort and computes what stays the same over the step.
// After the hot records were made; the next three are for those joints.
void prepare_joints(StepContext& step, Effort effort);
void warm_start_joints(StepContext& step);
void solve_joints(StepContext& step, double h, bool relax);  // h: sub-step, s
// After the last sub-step: loads into the joints; what was overloaded breaks.
void finish_joints(StepContext& step);

}  // namespace jostle::physics
