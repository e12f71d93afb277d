// SPDX-License-Identifier: MIT
//
// Holds figures together as they hit something. Limits and points are solved before and after the
// contacts of a sub-step, each joint alone, and for straight motions: an impact that turns a limb
// by a tenth of a radian within the sub-step pushes it through its limits and opens its joints.
// Where that would happen, all joints and limits of the group are solved together at the positions
// that its bodies would reach.
//
// Read: joints, warm records. Write: LimitedGroups, SolverScratch::limited_groups of the task's
// joints, SolverScratch::hot, the loads in the levels.
#pragma once

#include "physics/src/stages/solver/solve_joints.h"

namespace jostle::physics {

// Call after the joints are written.
void find_limited_groups(StepContext& step, const JointTask& task);
// Call when all velocities of a sub-step of h seconds are final, before the bodies advance.
void hold_limited_groups(StepContext& step, const JointTask& task, double h);

}  // namespace jostle::physics
