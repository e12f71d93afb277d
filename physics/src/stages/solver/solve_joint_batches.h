// SPDX-License-Identifier: MIT
//
// The passes over point rows of directly solved joint groups, interleaved with contacts
// (constraints/joints/joint_batches.h). Call the functions in the order below: the first two during
// prepare_joints(), the others in each sub-step.
//
// Read: joints, JointTask::levels. Write: JointTask::batches, SolverScratch::hot; the point
// impulses in the levels.
#pragma once

#include "physics/src/stages/solver/joint_task.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Call after lanes are assigned to the joints.
void find_joint_batches(StepContext& step, const JointTask& task);
// Call after their lanes are written. h: length of a sub-step, s, here and below.
void load_joint_batches(StepContext& step, const JointTask& task, double h);
// Projects velocities onto the point constraints and corrects position errors: before the contacts
// of the soft pass, and with `again` after them.
void solve_joint_batches(StepContext& step, const JointTask& task, double h, bool again);
// Projects rigidly after the contacts of the relaxing pass, at the bodies' new poses.
void relax_joint_batches(StepContext& step, const JointTask& task, double h);

}  // namespace jostle::physics
