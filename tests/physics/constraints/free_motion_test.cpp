// SPDX-License-Identifier: MIT
//
// One body in flight: exact under a constant force, and true to its energy and momentum when it
// tumbles. Worlds in flight: behaviour/free_motion_test.cpp.
#include "physics/src/constraints/free_motion.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

// 5 kg; 2, 4 and 5 kg m^2 about its axes.
BodyCold plank() {
    BodyCold cold;
    cold.mass = 5;
    cold.isotropic = false;
    cold.inertia = diagonal({2, 4, 5});
    invert_mass(cold);
    return cold;
}
BodyWarm turned(Quat rotation) {
    return {.rotation = rotation, .axes = to_matrix(rotation)};
}

// Whatever the length of a step: x = v t + a t^2 / 2.
TEST(FreeMotion, follows_the_parabola) {
    BodyWarm warm = turned({});
    warm.v = {3, 0, 0};
    warm.force = {0, 0, 10};
    for (const double t : {0.001, 0.25, 10.0}) {
        const FreeMotion m = free_motion(warm, plank(), {0, -10, 0}, t);
        EXPECT_TRUE(near(m.displacement, {3 * t, -5 * t * t, t * t}, 1e-12 * (1 + t * t * 100)));
        EXPECT_TRUE(near(m.v, {3, -10 * t, 2 * t}, 1e-12 * (1 + t * 100)));
    }
}

TEST(FreeMotion, respects_locked_axes_and_gravity_scale) {
    BodyCold cold = plank();
    cold.locks = lock_x;
    cold.gravity_scale = -0.5;
    BodyWarm warm = turned({});
    warm.force = {10, 0, 10};
    EXPECT_TRUE(near(acceleration_of(warm, cold, {3, -10, 0}), {0, 5, 2}, 1e-12));
}

// A kinematic body goes where its velocity takes it and feels nothing.
TEST(FreeMotion, kinematic_body_keeps_its_velocity) {
    BodyCold cold;
    cold.type = BodyType::kinematic;
    cold.linear_damping = 5;
    BodyWarm warm = turned({});
    warm.v = {1, 0, 0};
    warm.w = {0, pi, 0};
    const FreeMotion m = free_motion(warm, cold, {0, -10, 0}, 0.5);
    EXPECT_EQ(m.displacement, (Vec3{0.5, 0, 0}));
    EXPECT_EQ(m.v, warm.v);
    EXPECT_TRUE(near(rotate(m.rotation, {1, 0, 0}), {0, 0, -1}, 1e-12)) << "a quarter turn";
}

// A tumbling plank, turned by steps of 1/60 s for ten seconds.
TEST(FreeMotion, tumbling_conserves_energy_and_angular_momentum) {
    Random random(161);
    for (int round = 0; round < 10; round++) {
        const BodyCold cold = plank();
        BodyWarm warm = turned(random.rotation());
        warm.w = random.vector(10);
        const auto momentum = [&] {
            return warm.axes * (cold.inertia * transposed_times(warm.axes, warm.w));
        };
        const Vec3 before = momentum();
        const double energy = dot(before, warm.w);
        for (int step = 0; step < 600; step++) {
            const FreeSpin spin = free_spin(warm, cold, 1.0 / 60);
            warm.rotation = spin.rotation;
            warm.axes = to_matrix(spin.rotation);
            warm.w = spin.w;
        }
        EXPECT_TRUE(near(momentum(), before, 1e-9 * length(before))) << round;
        EXPECT_NEAR(dot(momentum(), warm.w), energy, 1e-9 * energy) << round;
    }
}

TEST(FreeMotion, negative_dt_returns_to_the_start) {
    BodyWarm warm = turned(from_axis_angle({1, 2, 3}, 0.5));
    warm.w = {5, -3, 2};
    const FreeSpin there = free_spin(warm, plank(), 0.1);
    BodyWarm later = turned(there.rotation);
    later.w = there.w;
    const FreeSpin back = free_spin(later, plank(), -0.1);
    EXPECT_TRUE(near(back.w, warm.w, 1e-9));
    EXPECT_TRUE(near(rotate(back.rotation, {1, 0, 0}), warm.axes.x, 1e-9));
}

// Euler's equations are solved in the principal axes, whatever the body's frame is.
TEST(FreeMotion, frame_does_not_change_the_motion) {
    const BodyCold straight = plank();
    EXPECT_TRUE(near(bend_of(straight.principal), {0.5, -0.75, 0.4}, 1e-12));
    const Mat3 turn = to_matrix(from_axis_angle({1, 1, 0}, 0.4));
    BodyCold askew = plank();
    askew.inertia = turn * askew.inertia * transpose(turn);
    invert_mass(askew);
    const Vec3 w{3, -2, 4};
    const EulerStep plain = euler_step(straight, w, 0.1), whole = euler_step(askew, turn * w, 0.1);
    EXPECT_TRUE(near(whole.w, turn * plain.w, 1e-9));
    EXPECT_TRUE(
        near(rotate(whole.rotation, turn.x), turn * rotate(plain.rotation, {1, 0, 0}), 1e-9));
}

// Its axes may be taken as they stood as long as it turns by less than 0.02 rad in a step.
TEST(FreeMotion, gyroscopic_requires_fast_rotation_and_anisotropic_inertia) {
    BodyWarm warm = turned({});
    warm.w = {0, 2.1, 0};
    EXPECT_TRUE(is_gyroscopic(warm, plank(), 0.01, 0.02));
    warm.w = {0, 1.9, 0};
    EXPECT_FALSE(is_gyroscopic(warm, plank(), 0.01, 0.02));
    warm.w = {0, 100, 0};
    BodyCold ball = plank();
    ball.isotropic = true;
    EXPECT_FALSE(is_gyroscopic(warm, ball, 0.01, 0.02));
    BodyCold hinged = plank();
    hinged.locks = lock_rotation_x;
    EXPECT_FALSE(is_gyroscopic(warm, hinged, 0.01, 0.02));
}

// dv/dt = -c v leaves exp(-c t): to third order where it is small, and never below zero.
TEST(FreeMotion, damping_matches_the_exponential) {
    EXPECT_NEAR(damping_factor(0.5, 0.1), 0.951229, 2e-5);
    EXPECT_EQ(damping_factor(0, 0.1), 1);
    EXPECT_GT(damping_factor(1e4, 0.25), 0);
}

}  // namespace
}  // namespace jostle::test
