// SPDX-License-Identifier: MIT
//
// The joint passes of solve_constraints, interleaved with the contact passes. Call the functions in
// the order below: prepare, then solve and relax in each sub-step, finish, and break after all
// tasks.
//
// Read: joints, warm records. Write: SolverScratch::hot, JointTask::levels; at the end impulses and
// loads of joints.
#pragma once

#include "physics/src/stages/solver/joint_task.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Finds the joints and writes the kernel data. Call after the hot records are built. h: length of a
// sub-step, s, here and below.
void prepare_joints(StepContext& step, const JointTask& task, double h);
// Returns whether threads share most of the passes below.
bool shares_levels(const JointTask& task);
// Warm-starts with the joint impulses of the previous sub-step, then runs a soft pass that corrects
// position errors.
void solve_joints(StepContext& step, const JointTask& task, double h);
// A rigid pass without position correction.
void relax_joints(StepContext& step, const JointTask& task, double h);
// Call after the last sub-step: writes impulses and loads to the joints.
void finish_joints(StepContext& step, const JointTask& task);
// Call serially after all tasks: breaks overloaded joints in ascending order, with an event for
// each. Counts the joints for the profile.
void break_joints(StepContext& step);

}  // namespace jostle::physics
