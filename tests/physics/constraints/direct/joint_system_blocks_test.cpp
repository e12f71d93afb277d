// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/joint_system_blocks.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {
using physics::BlockLdl;
using physics::JointEnds;
using physics::JointSystemBlock;

// Beads on a line, 1 kg each, of which joints hold the distance: J has -1 at a and 1 at b.
TEST(JointSystemBlocks, beads_on_a_line_yield_a_chain_matrix) {
    // A ring of five beads of which the first is held, and a joint beside it to the world.
    const std::vector<JointEnds> joints{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}, {5, 2}};
    const std::vector<std::uint8_t> pushed{0, 1, 1, 1, 1, 0};
    const std::vector<int> rows(joints.size(), 1);
    BlockLdl matrix;
    std::vector<JointSystemBlock> system_blocks;
    ASSERT_TRUE(find_joint_system_blocks(joints, rows, pushed, 1000, matrix, system_blocks));
    matrix.clear();
    for (const JointSystemBlock& c : system_blocks)
        matrix.values()[static_cast<std::size_t>(c.at)] += c.later_b == c.sooner_b ? 1 : -1;

    const auto moves = [&](std::size_t joint, int body) {
        if (pushed[static_cast<std::size_t>(body)] == 0) return 0.0;
        return (joints[joint].b == body ? 1.0 : 0.0) - (joints[joint].a == body ? 1.0 : 0.0);
    };
    int blocks = 0;
    for (std::size_t i = 0; i < joints.size(); i++)
        for (std::size_t k = 0; k <= i; k++) {
            double expected = 0;
            for (int body = 0; body < 6; body++) expected += moves(i, body) * moves(k, body);
            if (expected == 0) continue;
            blocks++;
            const int x = static_cast<int>(i), y = static_cast<int>(k);
            const int at = matrix.is_later(x, y) ? matrix.block_at(x, y) : matrix.block_at(y, x);
            EXPECT_EQ(matrix.values()[static_cast<std::size_t>(at)], expected) << i << " " << k;
        }
    EXPECT_EQ(blocks, 12);  // six of joints with themselves, four of the ring, two of the branch
}

TEST(JointSystemBlocks, rejects_excessive_work_before_factoring) {
    // Forty bodies of which each is tied to each.
    std::vector<JointEnds> joints;
    for (int b = 1; b < 40; b++)
        for (int a = 0; a < b; a++) joints.push_back({a, b});
    BlockLdl matrix;
    std::vector<JointSystemBlock> system_blocks;
    EXPECT_FALSE(find_joint_system_blocks(joints, std::vector<int>(joints.size(), 3),
                                          std::vector<std::uint8_t>(40, 1), 1'000'000, matrix,
                                          system_blocks));
    EXPECT_TRUE(system_blocks.empty());
}

}  // namespace
}  // namespace jostle::test
