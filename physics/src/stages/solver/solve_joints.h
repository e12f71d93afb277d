// SPDX-License-Identifier: MIT
//
// The joint passes of solve_constraints, beside the contacts. In the order of the functions below:
// prepare, then solve and relax in each sub-step, finish, and break when all tasks are done.
//
// Read: joints, warm records. Write: SolverScratch::hot, JointTask::levels; at the end impulses and
// loads of joints.
#pragma once

#include "physics/src/stages/solver/joint_task.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Finds the joints and writes what the kernels read. After the hot records were made. h: s, of a
// sub-step, here and below.
void prepare_joints(StepContext& step, const JointTask& task, double h);
// Whether threads share most of the passes below.
bool shares_levels(const JointTask& task);
// Warm start with what the joints did in the sub-step before, and a soft pass that pulls them
// together.
void solve_joints(StepContext& step, const JointTask& task, double h);
// A rigid pass without that pull.
void relax_joints(StepContext& step, const JointTask& task, double h);
// After the last sub-step: impulses and loads into the joints.
void finish_joints(StepContext& step, const JointTask& task);
// After all tasks, serially: what was overloaded breaks, in order of joints, and becomes an event.
// Counts the profile's joints.
void break_joints(StepContext& step);

}  // namespace jostle::physics
