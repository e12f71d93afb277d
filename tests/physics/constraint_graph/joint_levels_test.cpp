// SPDX-License-Identifier: MIT
//
// Chains take a level a link, what hangs on walls takes one, and like joints share blocks.
#include "physics/src/constraint_graph/joint_levels.h"

#include <gtest/gtest.h>

#include <vector>

#include "jostle/physics/joint_defs.h"

namespace jostle::test {
namespace {
using namespace physics;

const auto ball_kind = static_cast<std::uint32_t>(JointKind(BallJoint{}).index());
const auto hinge_kind = static_cast<std::uint32_t>(JointKind(HingeJoint{}).index());

struct Link {
    std::int32_t a, b;
    std::uint32_t kind = ball_kind;
};

JointLevels levels_of(const std::vector<Link>& links, std::size_t bodies) {
    JointLevels levels;
    for (std::uint32_t k = 0; k < links.size(); k++)
        levels.joints.push_back(
            {.joint = k, .kind = links[k].kind, .a = links[k].a, .b = links[k].b});
    assign_levels(levels, bodies);
    return levels;
}

// Hot indices first, first + 1, ...
std::vector<Link> chain(std::int32_t first, int links) {
    std::vector<Link> chain;
    for (std::int32_t k = first; k < first + links; k++) chain.push_back({k, k + 1});
    return chain;
}

TEST(JointLevels, chain_of_twenty_links_has_twenty_levels) {
    const JointLevels levels = levels_of(chain(1, 20), 22);
    ASSERT_EQ(levels.runs.size(), 20u);
    for (std::uint32_t k = 0; k < 20; k++) {
        EXPECT_EQ(levels.runs[k].begin, static_cast<int>(k));
        EXPECT_EQ(levels.runs[k].end, static_cast<int>(k) + 1);
        EXPECT_EQ(levels.metas[k].count, 1);
        EXPECT_EQ(levels.metas[k].joint[0], k) << "in their own order";
    }
}

// Nothing pushes body 0, which is every wall: twenty pendulums are one level in three blocks.
TEST(JointLevels, twenty_pendulums_on_a_wall_have_one_level) {
    std::vector<Link> star;
    for (std::int32_t k = 1; k <= 20; k++) star.push_back({0, k});
    const JointLevels levels = levels_of(star, 21);
    ASSERT_EQ(levels.runs.size(), 1u);
    EXPECT_EQ(levels.runs[0].end, 3);
    EXPECT_EQ(levels.blocks.size(), 3u);
    EXPECT_EQ(levels.metas[0].count, 8);
    EXPECT_EQ(levels.metas[2].count, 4);
    EXPECT_EQ(levels.metas[1].joint[3], 11u);
    EXPECT_EQ(levels.metas[1].b[3], 12);
}

// Kinematic bodies, below 0, are moved by nobody either.
TEST(JointLevels,
     twenty_pendulums_have_one_level_on_a_kinematic_body_and_twenty_on_a_dynamic_ball) {
    std::vector<Link> crane, ball_in_the_middle;
    for (std::int32_t k = 2; k <= 21; k++) {
        crane.push_back({-1, k});
        ball_in_the_middle.push_back({1, k});
    }
    EXPECT_EQ(levels_of(crane, 22).runs.size(), 1u);
    EXPECT_EQ(levels_of(ball_in_the_middle, 22).runs.size(), 20u);
}

TEST(JointLevels, eight_parallel_chains_fill_the_blocks_of_one) {
    std::vector<Link> links;
    for (int k = 0; k < 8; k++)
        for (const Link& link : chain(1 + 11 * k, 10)) links.push_back(link);
    const JointLevels levels = levels_of(links, 89);
    EXPECT_EQ(levels.runs.size(), 10u);
    ASSERT_EQ(levels.blocks.size(), 10u);
    for (std::uint32_t level = 0; level < 10; level++) {
        EXPECT_EQ(levels.metas[level].count, 8);
        for (std::uint32_t lane = 0; lane < 8; lane++)
            EXPECT_EQ(levels.metas[level].joint[lane], 10 * lane + level);
    }
}

// Each kind has a kernel of its own, so it has a run of its own in each level; ball joints have no
// angular rows.
TEST(JointLevels, kinds_within_a_level_are_solved_sequentially) {
    const JointLevels levels = levels_of(
        {{1, 2, hinge_kind}, {3, 4, ball_kind}, {5, 6, hinge_kind}, {2, 3, hinge_kind}}, 7);
    ASSERT_EQ(levels.runs.size(), 3u);
    EXPECT_EQ(levels.runs[0].kind, ball_kind);
    EXPECT_EQ(levels.runs[0].angular, -1);
    EXPECT_EQ(levels.metas[0].angular, -1);
    EXPECT_EQ(levels.runs[1].kind, hinge_kind);
    EXPECT_EQ(levels.runs[1].angular, 0);
    EXPECT_EQ(levels.metas[1].count, 2);
    EXPECT_EQ(levels.runs[2].kind, hinge_kind);
    EXPECT_EQ(levels.runs[2].angular, 1);
    EXPECT_EQ(levels.metas[2].joint[0], 3u) << "after both of its neighbours";
    EXPECT_EQ(levels.angular.size(), 2u);
}

// Made anew each step: nothing of the last one's is left.
TEST(JointLevels, no_joints_yield_no_levels_after_a_chain) {
    JointLevels levels = levels_of(chain(1, 5), 7);
    levels.joints.clear();
    assign_levels(levels, 7);
    EXPECT_TRUE(levels.runs.empty());
    EXPECT_TRUE(levels.blocks.empty());
    EXPECT_EQ(angular_of(levels, -1), nullptr);
}

}  // namespace
}  // namespace jostle::test
