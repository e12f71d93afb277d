// SPDX-License-Identifier: MIT
//
// The joint passes of solve_constraints, beside the contacts.
#pragma once

#include <cstdint>
#include <span>

#include "constraint_graph/joint_levels.h"
#include "stages/step_context.h"

namespace jostle::physics {

// The joints of one task of the solver: of these bodies, by hot index. Tasks may be solved at the
// same time.
struct JointTask {
    JointLevels& levels;
    std::span<const std::uint32_t> bodies;
};

// Finds the joints and writes what the kernels read. After the hot records were made. h: sub-step,
// s.
void prepare_joints(StepContext& step, const JointTask& task, double h);
// Whether threads share most of the passes below.
bool shares_levels(const JointTask& task);
// What joints did in the sub-step before, again, and a pass with push.
void solve_joints(StepContext& step, const JointTask& task, double h);
void relax_joints(StepContext& step, const JointTask& task, double h);
// After the last sub-step: loads into the joints.
void finish_joints(StepContext& step, const JointTask& task);
// After all tasks: what was overloaded breaks. Adds up the profile's joints.
void break_joints(StepContext& step);

}  // namespace jostle::physics
