// SPDX-License-Identifier: MIT
//
// The joint passes of solve_constraints, beside the contacts.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

// Finds the joints of the islands of one effort and writes what the kernels read. After the hot
// records were made; the rest is for those joints. h: sub-step, s.
void prepare_joints(StepContext& step, Effort effort, double h);
// What joints did in the sub-step before, again, and a pass with push.
void solve_joints(StepContext& step, double h);
void relax_joints(StepContext& step, double h);
// After the last sub-step: loads into the joints; what was overloaded breaks.
void finish_joints(StepContext& step);

}  // namespace jostle::physics
