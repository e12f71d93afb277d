// SPDX-License-Identifier: MIT
//
// Free bodies. A projectile follows its parabola for any step length, because constant forces are
// integrated exactly. A body that rotates about its middle axis flips repeatedly (Dzhanibekov):
// compared with Euler's equations, solved here by Runge-Kutta with steps of 1/19200 s.
#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {

namespace {
using namespace physics;

TEST(FreeFall, projectile_follows_its_parabola_for_four_seconds) {
    for (const Vec3 v0 : {Vec3{3, 4, 5}, Vec3{-7, 12, 0.3}, Vec3{0, -20, 1}}) {
        World world = make_world();
        const BodyId ball = add(world, {.position = {1, 2, 3}, .velocity = v0, .spin = {1, 2, 3}});
        run(world, 4);
        EXPECT_TRUE(near(position_of(world, ball),
                         Vec3{1, 2, 3} + v0 * 4 + world.gravity() * (0.5 * 4 * 4), 1e-9));
        EXPECT_TRUE(near(velocity_of(world, ball), v0 + world.gravity() * 4, 1e-9));
    }
}

TEST(FreeFall, constant_user_force_adds_to_gravity) {
    World world = make_world({.gravity = {1, -9, 2}, .substeps = 3});
    const BodyId box = add(world, {.velocity = {1, 1, 1}});  // 1000 kg
    const Vec3 force{2000, 500, -3000};
    for (int i = 0; i < 240; i++) {
        must(world.apply_force(box, force, state_of(world, box).center));
        must(world.step(1.0 / 60));
    }
    const Vec3 acceleration = world.gravity() + force / 1000;
    EXPECT_TRUE(
        near(position_of(world, box), Vec3{1, 1, 1} * 4 + acceleration * (0.5 * 4 * 4), 1e-9));
}

TEST(FreeFall, force_acts_for_one_step_only) {
    World world = make_world({.gravity = {}});
    const BodyId box = add(world, {});
    must(world.apply_force(box, {6000, 0, 0}, {}));
    run(world, 1);
    EXPECT_NEAR(velocity_of(world, box).x, 6.0 / 60, 1e-12);  // F dt / m
}

TEST(FreeFall, damping_matches_the_exponential_to_first_order) {
    World world = make_world({.gravity = {}});
    const double c = 0.5, t = 4;
    const BodyId box =
        must(world.create_body({.linear_velocity = {8, 0, 0}, .linear_damping = c}, ShapeDef{}));
    run(world, t);
    EXPECT_NEAR(velocity_of(world, box).x, 8 * std::exp(-c * t), 0.01 * 8 * std::exp(-c * t));
    EXPECT_NEAR(position_of(world, box).x, 8 / c * (1 - std::exp(-c * t)), 0.01 * 16);
}

TEST(FreeFall, negative_gravity_scale_reverses_the_weight) {
    World world = make_world();
    const BodyId balloon = must(world.create_body({.gravity_scale = -1}, ShapeDef{}));
    const BodyId ghost =
        must(world.create_body({.pose = {{9, 0, 0}, {}}, .gravity_scale = 0}, ShapeDef{}));
    run(world, 2);
    EXPECT_NEAR(position_of(world, balloon).y, 0.5 * 9.81 * 4, 1e-9);
    EXPECT_EQ(position_of(world, ghost), (Vec3{9, 0, 0}));
}

TEST(FreeFall, is_accurate_to_double_precision_far_from_the_origin) {
    World world = make_world();
    const BodyId ball = add(world, {.position = {1e6, 0, -1e6}, .velocity = {3, 4, 5}});
    run(world, 4);
    EXPECT_TRUE(
        near(position_of(world, ball), Vec3{1e6 + 12, 16 - 0.5 * 9.81 * 16, -1e6 + 20}, 1e-7));
}

const Vec3 moments{0.1, 0.2, 0.28};  // kg m^2 of a box of 1 kg
const Vec3 spin{0.01, 5, 0.01};      // rad/s

BuiltBody wing_nut() {
    // I = m/3 (hy^2 + hz^2, ...) solved for the half extents.
    const Vec3 h{square_root(0.57), square_root(0.27), square_root(0.03)};
    return {.geometry = Box{h}, .spin = spin, .density = 1 / (8 * h.x * h.y * h.z)};
}

// Euler's equations in body axes: I w' = I w x w.
Vec3 euler(Vec3 w) {
    return {(moments.y - moments.z) * w.y * w.z / moments.x,
            (moments.z - moments.x) * w.z * w.x / moments.y,
            (moments.x - moments.y) * w.x * w.y / moments.z};
}
Vec3 runge_kutta(Vec3 w, double h) {
    const Vec3 a = euler(w), b = euler(w + a * (h / 2)), c = euler(w + b * (h / 2)),
               d = euler(w + c * h);
    return w + (a + (b + c) * 2 + d) * (h / 6);
}

TEST(FreeRotation, intermediate_axis_flips_at_the_analytic_time) {
    World world = make_world({.gravity = {}});
    const BodyId body = add(world, wing_nut());
    const Vec3 L0 = Vec3{moments.x * spin.x, moments.y * spin.y, moments.z * spin.z};
    const double E0 = 0.5 * dot(L0, spin);

    Vec3 truth = spin, last_truth = spin, last_w = spin;
    std::vector<double> flips, true_flips;
    double momentum_drift = 0, energy_drift = 0;
    for (int i = 1; i <= 600; i++) {
        must(world.step(1.0 / 60));
        const BodyState s = state_of(world, body);
        const Vec3 L = s.inertia * s.angular_velocity;
        momentum_drift = maximum(momentum_drift, absolute(length(L) / length(L0) - 1));
        energy_drift = maximum(energy_drift, absolute(0.5 * dot(L, s.angular_velocity) / E0 - 1));
        const Vec3 w = inverse_rotate(s.pose.rotation, s.angular_velocity);
        for (int k = 0; k < 320; k++) truth = runge_kutta(truth, 1.0 / 19200);
        const auto note = [&](std::vector<double>& list, Vec3 before, Vec3 now) {
            if (before.y * now.y <= 0)
                list.push_back((i - 1 + before.y / (before.y - now.y)) / 60.0);
        };
        note(flips, last_w, w);
        note(true_flips, last_truth, truth);
        last_w = w;
        last_truth = truth;
    }
    RecordProperty("momentum_drift", std::to_string(momentum_drift * 1e9) + "e-9");
    RecordProperty("energy_drift", std::to_string(energy_drift));
    EXPECT_LT(momentum_drift, 1e-9);
    EXPECT_LT(energy_drift, 1e-2);
    ASSERT_EQ(true_flips.size(), 2u);
    EXPECT_NEAR(true_flips[0], 3.0823, 1e-2);
    ASSERT_EQ(flips.size(), 2u);
    RecordProperty("first_flip_off_s", std::to_string(flips[0] - true_flips[0]));
    EXPECT_NEAR(flips[0], true_flips[0], 0.15);
    EXPECT_NEAR(flips[1], true_flips[1], 0.30);
}

TEST(FreeRotation, conserves_energy_and_momentum_for_ten_minutes) {
    World world = make_world({.gravity = {}});
    const BodyId body = add(world, wing_nut());
    const BodyState start = state_of(world, body);
    const Vec3 L0 = start.inertia * start.angular_velocity;
    const double E0 = 0.5 * dot(L0, start.angular_velocity);
    double momentum_drift = 0, energy_drift = 0;
    for (int i = 0; i < 36000; i++) {
        must(world.step(1.0 / 60));
        if (i % 60 != 0) continue;
        const BodyState s = state_of(world, body);
        const Vec3 L = s.inertia * s.angular_velocity;
        momentum_drift = maximum(momentum_drift, length(L - L0) / length(L0));
        energy_drift = maximum(energy_drift, absolute(0.5 * dot(L, s.angular_velocity) / E0 - 1));
    }
    RecordProperty("momentum_vector_drift", std::to_string(momentum_drift * 1e9) + "e-9");
    RecordProperty("energy_drift", std::to_string(energy_drift));
    EXPECT_LT(momentum_drift, 1e-2);
    EXPECT_LT(energy_drift, 1e-2);
}

TEST(FreeRotation, sphere_rotates_at_a_constant_rate) {
    World world = make_world({.gravity = {}});
    const BodyId ball = add(world, {.geometry = Sphere{}, .spin = {0, 0, 2}});
    run(world, 1);
    const Quat q = state_of(world, ball).pose.rotation;
    EXPECT_NEAR(absolute(q.z), std::sin(1.0), 1e-9);  // half of 2 rad
    EXPECT_NEAR(norm_squared(q), 1, 1e-12);
}

TEST(FreeRotation, angular_impulse_is_divided_by_the_inertia) {
    World world = make_world({.gravity = {}});
    const BodyId ball = add(world, {.geometry = Sphere{0.5}});
    const double inertia = 0.4 * 1000 * 4.0 / 3 * pi * 0.125 * 0.25;  // 2/5 m r^2
    must(world.apply_angular_impulse(ball, {0, inertia * 3, 0}));
    EXPECT_TRUE(near(state_of(world, ball).angular_velocity, {0, 3, 0}, 1e-12));
    must(world.apply_torque(ball, {inertia * 60, 0, 0}));
    must(world.step(1.0 / 60));
    EXPECT_NEAR(state_of(world, ball).angular_velocity.x, 1, 1e-9);
}

}  // namespace

}  // namespace jostle::test
