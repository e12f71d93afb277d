// SPDX-License-Identifier: MIT
//
// Sums over the world against what mechanics says of its bodies.
#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// A ball of 2 kg at (0, 3, 0) with 4 m/s and 5 rad/s: 16 J, 0.4 m r^2 w^2 / 2 of spin, m g h.
TEST(Summary, energies_and_momenta_match_closed_forms) {
    World world = make_world({.gravity = {0, -10, 0}});
    const BodyId ball = must(world.create_body({.pose = {.position = {0, 3, 0}},
                                                .linear_velocity = {4, 0, 0},
                                                .angular_velocity = {0, 0, 5},
                                                .mass = 2},
                                               {.geometry = Sphere{0.5}}));
    const WorldSummary sum = world.summary();
    EXPECT_NEAR(sum.kinetic_energy, 16 + 0.5 * 0.4 * 2 * 0.25 * 25, 1e-9);
    EXPECT_NEAR(sum.potential_energy, 60, 1e-9);
    EXPECT_TRUE(near(sum.linear_momentum, {8, 0, 0}, 1e-9));
    EXPECT_TRUE(near(sum.angular_momentum, {0, 0, -24 + 0.4 * 2 * 0.25 * 5}, 1e-9));
    must(world.set_gravity_scale(ball, -1));
    EXPECT_NEAR(world.summary().potential_energy, -60, 1e-9);
}

TEST(Summary, counts_bodies_shapes_contacts_and_joints) {
    World world = make_world();
    add_floor(world);
    add(world, {.position = {0, 20, 0}, .type = BodyType::kinematic});
    for (int k = 0; k < 3; k++) add(world, {.position = {0, 0.5 + k, 0}});
    add(world, {.position = {9, 99, 0}});
    run(world, 0.2);
    const WorldSummary sum = world.summary();
    EXPECT_EQ(sum.bodies, 6);
    EXPECT_EQ(sum.dynamic_bodies, 4);
    EXPECT_EQ(sum.awake_bodies, 5);
    EXPECT_EQ(sum.shapes, 6);
    EXPECT_EQ(sum.contacts, 3);
    run(world, 2);
    EXPECT_EQ(world.summary().contacts, 3) << "asleep, too";
    EXPECT_EQ(world.summary().awake_bodies, 2);
}

// Two boxes a tenth of a metre in each other; awake and asleep contacts count.
TEST(Summary, reports_the_deepest_penetration) {
    World world = make_world({.gravity = {}});
    add(world, {});
    EXPECT_EQ(world.summary().max_penetration, 0);
    add(world, {.position = {0.9, 0, 0}});
    must(world.step(1e-4));
    EXPECT_NEAR(world.summary().max_penetration, 0.1, 1e-3);
}

// A ball joint whose ends are 0.25 m apart; a rope of 1 m that is 1.5 m long, and one that is
// slack.
TEST(Summary, reports_the_largest_joint_error) {
    World world = make_world({.gravity = {}});
    const BodyId a = add(world, {}), b = add(world, {.position = {3, 0, 0}});
    const auto tie = [&](double x, const JointKind& kind) {
        must(world.create_joint(
            {.body_a = a, .body_b = b, .frame_b = {.position = {x, 0, 0}}, .kind = kind}));
        return world.summary().max_joint_error;
    };
    EXPECT_EQ(tie(-2, DistanceJoint{.min_length = 0, .max_length = 1}), 0) << "1 m, as it may be";
    EXPECT_NEAR(tie(-2.75, BallJoint{}), 0.25, 1e-12);
    EXPECT_NEAR(tie(-1.5, DistanceJoint{.min_length = 0, .max_length = 1}), 0.5, 1e-12);
    EXPECT_EQ(world.summary().joints, 3);
}

}  // namespace
}  // namespace jostle::test
