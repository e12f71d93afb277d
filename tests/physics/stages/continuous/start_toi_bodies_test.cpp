// SPDX-License-Identifier: MIT
//
// Whom fast bodies look at on their way.
#include <gtest/gtest.h>

#include "physics/src/stages/continuous/start_toi_bodies.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {

namespace {
using namespace physics;

// Two upright rods 1 m long and 6 cm thick that fly along at 60 m/s, 20 cm apart: the balls around
// them overlap all the time.
struct TwoRods {
    World world = make_world({.gravity = {}});
    BodyId left, right;

    explicit TwoRods(double toward) {
        const Capsule rod{0.03, 0.47};
        left = add(world, {.geometry = rod, .velocity = {60, 0, 0}});
        right =
            add(world, {.geometry = rod, .position = {0, 0, 0.2}, .velocity = {60, 0, -toward}});
    }
    int sweeps_in(int steps) {
        int sweeps = 0;
        for (int k = 0; k < steps; k++) {
            must(world.step(1.0 / 60));
            sweeps += world.profile().sweeps;
        }
        return sweeps;
    }
};

// The pair's bound shows that they stay 14 cm apart, so nobody sweeps.
TEST(FindSweepCandidates, skips_pairs_within_their_separation_bound) {
    TwoRods rods(0);
    EXPECT_EQ(rods.sweeps_in(30), 0);
}

// At 10 m/s against each other they meet in the first step.
TEST(FindSweepCandidates, includes_pairs_that_exceed_their_separation_bound) {
    TwoRods rods(10);
    EXPECT_GT(rods.sweeps_in(1), 0);
    EXPECT_EQ(rods.world.profile().impacts, 1);
    const double gap =
        rods.world.body(rods.right)->pose.position.z - rods.world.body(rods.left)->pose.position.z;
    EXPECT_NEAR(gap, 0.06, 0.001) << "none went through the other";
}

// A ball at rest is hit by another and thrown at a third, which nothing came near to: who goes
// another way looks at all again.
TEST(FindSweepCandidates, deflected_body_searches_all_shapes_again) {
    World world = make_world({.gravity = {}});
    const Sphere ball{0.05};
    const BodyId hit = add(world, {.geometry = ball});
    const BodyId beside = add(world, {.geometry = ball, .position = {0, 0, 0.4}});
    add(world, {.geometry = ball, .position = {0, 0, -1}, .velocity = {0, 0, 120}});
    must(world.step(1.0 / 60));
    EXPECT_GE(world.profile().impacts, 2);
    EXPECT_GT(world.body(beside)->linear_velocity.z, 30) << "a third of it each";
    EXPECT_LT(world.body(hit)->pose.position.z, world.body(beside)->pose.position.z - 0.09)
        << "none went through the other";
}

}  // namespace

}  // namespace jostle::test
