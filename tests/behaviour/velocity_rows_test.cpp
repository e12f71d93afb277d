// SPDX-License-Identifier: MIT
//
// Rows that users give the solver: gears, motors along a line, dampers, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/joint_fixture.h"
#include "tests/support/near.h"

namespace jostle::test {
namespace {
using namespace physics;

JointId row(World& world, BodyId a, BodyId b, const VelocityRow& kind) {
    return must(
        world.create_joint({.body_a = a, .body_b = b, .kind = kind, .collide_connected = true}));
}

// A wheel of twice the radius turns half as fast, the other way. Each stands on a hinge of its own.
TEST(VelocityRows, gear_holds_its_ratio) {
    World world = make_world({.gravity = {}});
    const BodyId small =
        add(world, {.geometry = Sphere{0.5}, .position = {0, 0, 0}, .sleep_allowed = false});
    const BodyId large =
        add(world, {.geometry = Sphere{1.0}, .position = {4, 0, 0}, .sleep_allowed = false});
    const double torque = state_of(world, small).inertia.z.z * 10;
    must(world.create_joint({.body_a = anchor(world, {0, 0, 3}),
                             .body_b = small,
                             .frame_a = {{0, 0, -3}, {}},
                             .kind = HingeJoint{.motor = {true, 6, torque}}}));
    must(world.create_joint({.body_a = anchor(world, {4, 0, 3}),
                             .body_b = large,
                             .frame_a = {{0, 0, -3}, {}},
                             .kind = HingeJoint{}}));
    row(world, small, large, {.angular_a = {0, 0, 1}, .angular_b = {0, 0, 2}, .world_axes = true});
    // While it gains speed and when it has it: half of the motor's speed is the other wheel's.
    double worst = 0;
    for (int i = 0; i < 600; i++) {
        must(world.step(1.0 / 60));
        worst = std::max(worst, std::abs(state_of(world, small).angular_velocity.z +
                                         2 * state_of(world, large).angular_velocity.z));
    }
    EXPECT_NEAR(state_of(world, small).angular_velocity.z, 6, 1e-3);
    EXPECT_NEAR(state_of(world, large).angular_velocity.z, -3, 1e-3);
    EXPECT_LT(worst, 1e-3);
}

// A motor along a line, of 10 N at most: 2 kg gain 5 m/s^2 until they have its 3 m/s.
TEST(VelocityRows, bounds_limit_the_force) {
    World world = make_world({.gravity = {}});
    const BodyId cart = add(world, {.geometry = Sphere{0.5}, .sleep_allowed = false});
    must(world.set_mass(cart, 2));
    const JointId motor =
        row(world, anchor(world, {0, -3, 0}), cart,
            {.linear_b = {1, 0, 0}, .world_axes = true, .speed = 3, .lower = -10, .upper = 10});
    run(world, 0.3);
    EXPECT_NEAR(state_of(world, cart).linear_velocity.x, 1.5, 1e-4);
    EXPECT_NEAR(must(world.joint(motor)).force.x, 10, 1e-4);
    run(world, 0.7);
    EXPECT_NEAR(state_of(world, cart).linear_velocity.x, 3, 1e-5);
    EXPECT_NEAR(must(world.joint(motor)).force.x, 0, 1e-4);
    EXPECT_NEAR(state_of(world, cart).linear_velocity.y, 0, 1e-9);
}

// A damper of c = 4 N s/m on 2 kg: v = v0 exp(-c t / m). The solver's steps are implicit, of 1/480
// s: it keeps a share of 1 / (1 + c h / m) in each.
TEST(VelocityRows, softness_is_the_inverse_damping_constant) {
    World world = make_world({.gravity = {}});
    const BodyId cart =
        add(world, {.geometry = Sphere{0.5}, .velocity = {5, 1, 0}, .sleep_allowed = false});
    must(world.set_mass(cart, 2));
    row(world, anchor(world, {0, -3, 0}), cart,
        {.linear_b = {1, 0, 0}, .world_axes = true, .softness = 0.25});
    run(world, 1);
    EXPECT_NEAR(state_of(world, cart).linear_velocity.x, 5 * std::exp(-2.0), 0.01);
    EXPECT_NEAR(state_of(world, cart).linear_velocity.y, 1, 1e-9);
}

// A bias moves what is out of place and is gone with the step.
TEST(VelocityRows, bias_corrects_position_without_adding_velocity) {
    World world = make_world({.gravity = {}});
    const BodyId ball = add(world, {.geometry = Sphere{0.5}, .sleep_allowed = false});
    row(world, anchor(world, {0, -3, 0}), ball,
        {.linear_b = {0, 1, 0}, .world_axes = true, .bias = 0.6});
    must(world.step(1.0 / 60));
    EXPECT_NEAR(state_of(world, ball).pose.position.y, -0.01, 1e-6);
    EXPECT_NEAR(state_of(world, ball).linear_velocity.y, 0, 1e-6);
}

// A spinning rod is pushed along its own y axis, wherever that looks; its anchor's vectors are
// zero.
TEST(VelocityRows, frame_vectors_rotate_with_their_bodies) {
    World world = make_world({.gravity = {}});
    const BodyId rod =
        add(world, {.geometry = Box{{1, 0.1, 0.1}}, .spin = {0, 0, 2}, .sleep_allowed = false});
    row(world, anchor(world, {0, 0, 3}), rod, {.linear_b = {0, 1, 0}, .speed = 1});
    for (int i = 0; i < 120; i++) {
        must(world.step(1.0 / 60));
        const BodyState s = state_of(world, rod);
        const Vec3 y = rotate(s.pose.rotation, {0, 1, 0});
        // In a sub-step the rod turns by 2/480 rad, which shows the 4 m/s at most along its x axis.
        ASSERT_NEAR(dot(s.linear_velocity, y), 1, 0.02) << i;
        ASSERT_NEAR(s.angular_velocity.z, 2, 1e-5);
    }
}

// Two weights on one rope over a pulley without mass: J = v1.y + v2.y. Atwood: a = g (m1 - m2) /
// (m1 + m2).
TEST(VelocityRows, pulley_matches_the_atwood_machine) {
    World world = make_world();
    const BodyId heavy =
        add(world, {.geometry = Sphere{0.2}, .position = {-1, 0, 0}, .sleep_allowed = false});
    const BodyId light =
        add(world, {.geometry = Sphere{0.2}, .position = {1, 0, 0}, .sleep_allowed = false});
    must(world.set_mass(heavy, 3));
    must(world.set_mass(light, 1));
    const JointId rope = row(world, heavy, light,
                             {.linear_a = {0, 1, 0},
                              .linear_b = {0, 1, 0},
                              .world_axes = true,
                              .lower = 0});  // a rope pulls, and never pushes
    run(world, 1);
    EXPECT_NEAR(state_of(world, heavy).linear_velocity.y, -9.81 / 2, 1e-3);
    EXPECT_NEAR(state_of(world, light).linear_velocity.y, 9.81 / 2, 1e-3);
    EXPECT_NEAR(must(world.joint(rope)).force.y, 2 * 3 * 1 / 4.0 * 9.81, 0.01);
}

TEST(VelocityRows, break_above_their_force) {
    World world = make_world();
    const BodyId weight = add(world, {.geometry = Sphere{0.2}, .sleep_allowed = false});
    must(world.set_mass(weight, 2));
    const JointId held =
        must(world.create_joint({.body_a = anchor(world, {0, 3, 0}),
                                 .body_b = weight,
                                 .kind = VelocityRow{.linear_b = {0, 1, 0}, .world_axes = true},
                                 .break_force = 19}));  // it weighs 19.62 N
    must(world.step(1.0 / 60));
    must(world.step(1.0 / 60));
    EXPECT_FALSE(world.contains(held));
}

TEST(VelocityRows, are_saved_and_bit_identical_for_any_thread_count) {
    const auto make = [](int threads) {
        World world = make_world({.threads = threads});
        add_floor(world);
        BodyId last = {};
        for (int i = 0; i < 40; i++) {
            const BodyId ball = add(world, {.geometry = Sphere{0.4},
                                            .position = {i % 8 * 0.9, 0.5 + i / 8 * 0.9, 0.01 * i},
                                            .sleep_allowed = false});
            if (i > 0)
                row(world, last, ball,
                    {.angular_a = {0, 0, 1},
                     .angular_b = {0, 0.3, 1},
                     .speed = 0.5,
                     .lower = -2,
                     .upper = 3});
            last = ball;
        }
        return world;
    };
    World one = make(1), two = make(2);
    run(one, 1);
    run(two, 1);
    EXPECT_EQ(state_hash(one), state_hash(two));
    World three = must(load(save(one)));
    run(one, 0.5);
    run(three, 0.5);
    EXPECT_EQ(state_hash(one), state_hash(three));
}

}  // namespace
}  // namespace jostle::test
