// SPDX-License-Identifier: MIT
//
// The joints that the solver solves together, for solve_joints.h and solve_joint_batches.h.
#pragma once

#include <cstdint>
#include <span>

#include "physics/src/constraint_graph/joint_levels.h"
#include "physics/src/constraints/joints/joint_batches.h"

namespace jostle::physics {

// The joints of one task of the solver: of `bodies`, by hot index. Tasks may be solved at the same
// time.
struct JointTask {
    JointLevels& levels;
    JointBatches& batches;
    std::span<const std::uint32_t> bodies;
};

}  // namespace jostle::physics
