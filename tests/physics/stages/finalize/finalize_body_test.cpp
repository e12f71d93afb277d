// SPDX-License-Identifier: MIT
//
// The end of a step for one body: where it is, how long it rests, and what later stages must know.
#include "physics/src/stages/finalize/finalize_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/world_access.h"
#include "tests/support/step_time.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// A box of 1 m in a step of its own.
struct Step {
    World world = make_world({.gravity = {}});
    WorldState& state = state_of(world);
    StepScratch scratch;

    explicit Step(bool may_sleep = true) {
        add(world, {.sleep_allowed = may_sleep});
        must(world.step(dt));
        warm().sleep_time = 0;
    }
    BodyWarm& warm() { return state.bodies.awake[0]; }
    FinalizeScratch& found() { return scratch.finalize; }
    // By a velocity, straight on.
    void move(Vec3 v) { finalize(FreeMotion{v * dt, warm().rotation, v, {}}); }
    void finalize(const FreeMotion& motion) {
        StepContext step{state, scratch, *state.thread_pool, dt, {}};
        begin_finalize(state.bodies, {}, false, scratch.finalize);
        finalize_body(step, 0, motion);
    }
};

TEST(FinalizeBody, writes_pose_and_velocity_and_clears_forces) {
    Step step;
    step.warm().force = {5, 0, 0};
    step.warm().torque = {0, 5, 0};
    const double travel = step.state.bodies.motion[0].travel;
    const Quat turned = from_axis_angle({0, 1, 0}, 0.3);
    step.finalize(FreeMotion{{0.01, 0, 0}, turned, {0.6, 0, 0}, {0, 18, 0}});
    EXPECT_EQ(step.warm().center, (Vec3{0.01, 0, 0}));
    EXPECT_EQ(step.warm().rotation, turned);
    EXPECT_EQ(step.warm().w, (Vec3{0, 18, 0}));
    EXPECT_EQ(step.warm().force, Vec3{});
    EXPECT_EQ(step.warm().torque, Vec3{});
    const double radius = step.state.bodies.cold[0].radius;
    EXPECT_GE(step.state.bodies.motion[0].travel - travel, 0.01 + 0.3 * radius);
    EXPECT_LE(step.state.bodies.motion[0].travel - travel, 0.01 + 0.35 * radius);
}

// A box of 0.5 m inner radius: 0.25 m in a step is where looks between steps are not enough.
TEST(FinalizeBody, body_moving_half_its_thickness_is_fast) {
    Step slow, fast;
    slow.move({14.9, 0, 0});
    EXPECT_EQ(slow.found().fast[0], 0);
    fast.move({15.1, 0, 0});
    EXPECT_EQ(fast.found().fast[0], 1);
    EXPECT_EQ(fast.found().any_fast, 1);
    EXPECT_EQ(fast.found().previous[0].center, Vec3{}) << "where it was is kept";
}

// It went 5 cm forth and is said to move back at 6 m/s: contacts turned it round on the way.
TEST(FinalizeBody, deflected_body_did_not_follow_its_velocity) {
    Step step;
    step.finalize(FreeMotion{{0.05, 0, 0}, {}, {-6, 0, 0}, {}});
    EXPECT_EQ(step.found().deflected[0], 1);
    step.move({6, 0, 0});
    EXPECT_EQ(step.found().deflected[0], 0);
}

// What is not a number is not taken over.
TEST(FinalizeBody, rejects_a_non_finite_state) {
    const double none = std::nan("");
    for (const FreeMotion& motion :
         {FreeMotion{{none, 0, 0}, {}, {}, {}}, FreeMotion{{}, {none, 0, 0, 1}, {}, {}},
          FreeMotion{{}, {}, {0, none, 0}, {}}, FreeMotion{{}, {}, {}, {0, 0, 1.1e6}},
          FreeMotion{{1.1e8, 0, 0}, {}, {}, {}}}) {
        Step step;
        step.warm().v = {3, 0, 0};
        step.finalize(motion);
        EXPECT_EQ(step.found().not_finite[0], 1);
        EXPECT_EQ(step.warm().center, Vec3{}) << "it stays where it was";
        EXPECT_EQ(step.warm().v, Vec3{}) << "at rest";
    }
}

// Slower than 5 cm/s it rests; faster, but not by so much, it rests too within 4 mm.
TEST(FinalizeBody, slow_or_swaying_body_accumulates_rest_time) {
    Step step;
    for (int k = 0; k < 30; k++) step.move({0.049, 0, 0});
    EXPECT_NEAR(step.warm().sleep_time, 0.5, 1e-9);
    step.move({0.21, 0, 0});
    EXPECT_EQ(step.warm().sleep_time, 0);
    for (int k = 0; k < 30; k++) step.move({k % 2 == 0 ? 0.15 : -0.15, 0, 0});
    EXPECT_NEAR(step.warm().sleep_time, 0.5, 1e-9) << "2.5 mm to and fro";
    int steps = 0;
    for (; step.warm().sleep_time > 0; steps++) step.move({0.15, 0, 0});
    EXPECT_EQ(steps, 2) << "on and on it is 4 mm away after two";
}

TEST(FinalizeBody, body_that_may_not_sleep_accumulates_no_rest_time) {
    Step step(false);
    for (int k = 0; k < 10; k++) step.move({});
    EXPECT_EQ(step.warm().sleep_time, 0);
}

// 4 cm of margin, of which a quarter is kept: at 1.2 m/s, 2 cm a step, it leaves its fat box in the
// second step, and gets a new one.
TEST(FinalizeBody, leaving_the_fat_box_is_detected_one_step_early) {
    Step step;
    step.state.shapes.shapes[0].fat = {{-0.54, -0.54, -0.54}, {0.54, 0.54, 0.54}};
    step.state.bodies.motion[0].fits_until = 0;
    step.move({0.3, 0, 0});
    EXPECT_EQ(step.found().left_fat_aabb[0], 0);
    step.move({1.2, 0, 0});
    EXPECT_EQ(step.found().left_fat_aabb[0], 1);
    EXPECT_GT(step.state.shapes.shapes[0].fat.high.x, 0.58);
}

}  // namespace
}  // namespace jostle::test
