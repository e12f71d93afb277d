// SPDX-License-Identifier: MIT
//
// Which blocks the matrix J M^-1 J^T of some joints has: each body that they can push couples every
// two of its joints, and each with itself.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/constraints/direct/block_ldl.h"

namespace jostle::physics {

struct JointSystemBlock {
    int at;  // of the block among the matrix's values
    int later, sooner, body;
    bool later_b, sooner_b;  // whether it is their b
};
struct JointEnds {
    int a = 0, b = 0;  // bodies by number
};

// Analyses the matrix, a node a joint, and lists the blocks. False, and of no use, if a factor
// would take more multiplications than `max_work`. `pushed`: by body.
bool find_joint_system_blocks(std::span<const JointEnds> joints, std::span<const int> rows,
                              std::span<const std::uint8_t> pushed, std::int64_t max_work,
                              BlockLdl& matrix, std::vector<JointSystemBlock>& system_blocks);

}  // namespace jostle::physics
