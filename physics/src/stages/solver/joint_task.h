// SPDX-License-Identifier: MIT
//
// The joints of one solver task, for solve_joints.h and solve_joint_batches.h.
#pragma once

#include <cstdint>
#include <span>

#include "physics/src/constraint_graph/joint_levels.h"
#include "physics/src/constraints/joints/joint_batches.h"

namespace jostle::physics {

// The joints of one task of the solver: those of `bodies`, by hot index. Different tasks may run
// concurrently.
struct JointTask {
    JointLevels& levels;
    JointBatches& batches;
    std::span<const std::uint32_t> bodies;
};

}  // namespace jostle::physics
