// SPDX-License-Identifier: MIT
//
// The passes over points of joint groups that are solved at once, beside contacts
// (constraints/joints/joint_batches.h). In the order of the functions below: the first two as
// prepare_joints() does its work, the others in each sub-step.
//
// Read: joints, JointTask::levels. Write: JointTask::batches, SolverScratch::hot; into the levels
// the impulses of points.
#pragma once

#include "physics/src/stages/solver/joint_task.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Once the joints have their lanes.
void find_joint_batches(StepContext& step, const JointTask& task);
// Once their lanes are written. h: s, of a sub-step, here and below.
void load_joint_batches(StepContext& step, const JointTask& task, double h);
// Velocities to what the points allow, and what they are apart away: before the contacts of the
// soft pass, and `again` after them.
void solve_joint_batches(StepContext& step, const JointTask& task, double h, bool again);
// Rigidly, after the contacts of the relaxing pass; where the bodies then are.
void relax_joint_batches(StepContext& step, const JointTask& task, double h);

}  // namespace jostle::physics
