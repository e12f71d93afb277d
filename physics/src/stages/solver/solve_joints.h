// SPDX-License-Identifier: MIT
//
// The joint passes of solve_constraints, interleaved with the contact passes.
#pragma once

#include <cstdint>
#include <span>

#include "physics/src/constraint_graph/joint_levels.h"
#include "physics/src/constraints/joints/joint_batches.h"
#include "physics/src/stages/solver/limited_groups.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// The joints of one task of the solver: those of `bodies`, by hot index. Different tasks may run
// concurrently.
struct JointTask {
    JointLevels& levels;
    JointBatches& batches;
    LimitedGroups& limited;
    std::span<const std::uint32_t> bodies;
};

// The passes over point rows of directly solved joint groups, interleaved with contacts
// (constraints/joints/joint_batches.h). Call the functions in the order below: the first two during
// prepare_joints(), the others in each sub-step.
//
// Read: joints, JointTask::levels. Write: JointTask::batches, SolverScratch::hot; the point
// impulses in the levels.
//
// Call after lanes are assigned to the joints.
void find_joint_batches(StepContext& step, const JointTask& task);
// Call after their lanes are written. h: length of a sub-step, s, here and below.
void load_joint_batches(StepContext& step, const JointTask& task, double h);
// Projects velocities onto the point constraints and corrects position errors: before the contacts
// of the soft pass, and with `again` after them.
void solve_joint_batches(StepContext& step, const JointTask& task, double h, bool again);
// Projects rigidly after the contacts of the relaxing pass, at the bodies' new poses.
void relax_joint_batches(StepContext& step, const JointTask& task, double h);

// The passes over all other rows. Call the functions in the order below: prepare, then solve and
// relax in each sub-step, finish, and break after all tasks.
//
// Read: joints, warm records. Write: SolverScratch::hot, JointTask::levels; at the end impulses and
// loads of joints.
//
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
