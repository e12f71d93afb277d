// SPDX-License-Identifier: MIT
//
// Which pairs that are apart may touch in the next step.
#include "stages/contacts/separation_bound.h"

#include <gtest/gtest.h>

#include "state/contact_graph.h"
#include "state/separation_bounds.h"
#include "state/shape_proxy.h"
#include "state/world_access.h"
#include "support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double dt = 1.0 / 60;

// Two balls of 0.5 m, `gap` between them along x, without gravity.
struct TwoBalls {
    World world = make_world({.gravity = {}});
    WorldState& state = state_of(world);

    TwoBalls(double gap, Vec3 velocity_a, Vec3 velocity_b) {
        add(world, {.geometry = Sphere{0.5}, .velocity = velocity_a});
        add(world, {.geometry = Sphere{0.5}, .position = {1 + gap, 0, 0}, .velocity = velocity_b});
        create_contact(state, 0, 1);
    }
    SeparationBound& bound() { return state.contacts.bounds[0]; }
    // Waits with so much slack, along x or by length.
    void wait(double slack, Vec3 direction) {
        state.contacts.bounds.clear();
        state.contacts.contacts[0].has_bound = false;
        add_separation_bound(state, 0, slack, direction);
    }
    // As finalize does for one step.
    void move() {
        for (BodyWarm& warm : state.bodies.awake) {
            warm.center += warm.v * dt;
            state.bodies.motion[warm.body].travel += length(warm.v) * dt;
            update_motion_bound(state, warm.body, dt);
        }
    }
    int steps_until_due() {
        int steps = 0;
        while (!is_due(state, bound(), dt) && steps < 1000) {
            move();
            steps++;
        }
        return steps;
    }
};

// A metre apart, 6 m/s: 0.1 m a step. Along x it is asked for in the step that may use the rest.
TEST(SeparationBound, of_a_pair_that_closes_is_due_when_the_slack_is_gone) {
    TwoBalls balls(1, {6, 0, 0}, {});
    balls.wait(1, {1, 0, 0});
    EXPECT_EQ(balls.steps_until_due(), 9);
}

// Both fly at 50 m/s, and nothing changes between them.
TEST(SeparationBound, of_a_pair_that_flies_along_is_never_due) {
    TwoBalls balls(1, {50, 20, 0}, {50, 20, 0});
    balls.wait(1, {1, 0, 0});
    EXPECT_EQ(balls.steps_until_due(), 1000);
    balls.wait(1, {});
    EXPECT_EQ(balls.steps_until_due(), 1000);
}

// One passes the other at a distance: along the direction in which they are apart nothing closes,
// by the length of the motion it does.
TEST(SeparationBound, along_a_direction_sees_what_passes_by) {
    TwoBalls balls(1, {0, 6, 0}, {});
    balls.wait(1, {1, 0, 0});
    EXPECT_EQ(balls.steps_until_due(), 1000);
    TwoBalls by_length(1, {0, 6, 0}, {});
    by_length.wait(1, {});
    EXPECT_LT(by_length.steps_until_due(), 10);
}

// What was never looked at waits by the balls around both bodies, without a look.
TEST(SeparationBound, of_a_new_pair_is_found_by_spheres) {
    TwoBalls far(1, {6, 0, 0}, {}), near(0.05, {6, 0, 0}, {});
    EXPECT_FALSE(is_due(far.state, far.bound(), dt));
    EXPECT_TRUE(far.bound().directed);
    EXPECT_NE(far.bound().budget, SeparationBound::not_measured);
    EXPECT_TRUE(is_due(near.state, near.bound(), dt)) << "they meet in this step";
}

// A turn moves the surface: both balls spin, and the slack is used up without any motion.
TEST(SeparationBound, turning_counts) {
    TwoBalls balls(1, {}, {});
    balls.wait(0.05, {1, 0, 0});
    EXPECT_FALSE(is_due(balls.state, balls.bound(), dt));
    warm_of(balls.state, 0).w = {0, 0, 12};  // 0.1 m a step
    update_motion_bound(balls.state, 0, dt);
    EXPECT_TRUE(is_due(balls.state, balls.bound(), dt));
}

}  // namespace
}  // namespace jostle::test
