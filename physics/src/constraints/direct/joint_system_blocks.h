// SPDX-License-Identifier: MIT
//
// The block structure of the matrix J M^-1 J^T of some joints: each body that they can push couples
// every two of its joints, and each joint with itself.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/constraints/direct/joint_net.h"

namespace jostle::physics {

struct JointSystemBlock {
    int at;  // of the block in the matrix's values
    int later, sooner, body;
    bool later_b, sooner_b;  // whether the body is b of that joint
};
struct JointEnds {
    int a = 0, b = 0;  // body numbers
};

// Analyses the matrix with one node per joint and lists the blocks. Returns false, and the results
// are then unusable, if a factorisation would take more than `max_work` multiplications. `pushed`:
// indexed by body.
bool find_joint_system_blocks(std::span<const JointEnds> joints, std::span<const int> rows,
                              std::span<const std::uint8_t> pushed, std::int64_t max_work,
                              BlockLdl& matrix, std::vector<JointSystemBlock>& system_blocks);

}  // namespace jostle::physics
