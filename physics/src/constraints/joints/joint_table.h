// SPDX-License-Identifier: MIT
//
// Joint kind to its functions, and the passes over all joints of a step.
#pragma once

#include "constraints/joints/kinds.h"

namespace jostle::physics {

void warm_start(JointPair& pair, Joint& joint);
void solve(JointPair& pair, const JointStep& step, Joint& joint);
JointLoad load_of(const JointPair& pair, const Joint& joint);

// The numbers of a sub-step of h seconds. Joints are as stiff as the sub-step can carry: more
// sub-steps are stiffer.
JointStep joint_step(double h, bool relax);

}  // namespace jostle::physics
