// SPDX-License-Identifier: MIT
//
// Wind, attraction, whirls and water, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Quadratic drag at rest in wind of 20 m/s: v(t) = u - u / (1 + k u t), k = rho c A / 2 m.
TEST(ForceFields, wind_accelerates_a_ball_by_the_closed_form) {
    World world = make_world({.gravity = {}});
    const BodyId ball = add(world, {.geometry = Sphere{0.5}, .density = 10});
    must(world.create_field({.force = UniformWind{.velocity = {20, 0, 0}, .drag = 0.47}}));
    run(world, 3);
    const double mass = state_of(world, ball).mass, area = pi * 0.25;
    const double k = 0.5 * 1.2 * 0.47 * area / mass;
    EXPECT_NEAR(velocity_of(world, ball).x, 20 - 20 / (1 + k * 20 * 3), 1e-9);
}

// A parachutist of 80 kg under 1 m^2: sqrt(2 m g / rho c A).
TEST(ForceFields, falling_body_reaches_terminal_velocity) {
    World world = make_world();
    const BodyId body = must(world.create_body({.pose = {{0, 1000, 0}, {}}, .mass = 80},
                                               {.geometry = Box{{0.5, 0.1, 0.5}}}));
    must(world.create_field({.force = UniformWind{.drag = 1}}));
    run(world, 20);
    const double end = square_root(2 * 80 * 9.81 / (1.2 * 1));
    EXPECT_NEAR(-velocity_of(world, body).y, end, 0.01);
}

TEST(ForceFields, any_drag_is_stable) {
    World world = make_world({.gravity = {}});
    const BodyId feather =
        must(world.create_body({.mass = 1e-4}, {.geometry = Box{{0.5, 0.01, 0.5}}}));
    must(world.create_field({.force = UniformWind{.velocity = {0, 30, 0}, .density = 1000}}));
    for (int step = 0; step < 120; step++) {
        must(world.step(1.0 / 60));
        const double v = velocity_of(world, feather).y;
        ASSERT_TRUE(v > 0 && v <= 30) << "step " << step;
    }
    EXPECT_NEAR(velocity_of(world, feather).y, 30, 1e-3);
}

// A circular orbit of radius 10: v^2 = strength / r. Ten turns.
TEST(ForceFields, planet_stays_on_its_orbit) {
    World world = make_world({.gravity = {}});
    const BodyId planet =
        add(world, {.geometry = Sphere{0.1}, .position = {10, 0, 0}, .velocity = {0, 0, 10}});
    must(world.create_field(
        {.force = RadialField{.strength = -1000, .falloff = 2, .per_mass = true}}));
    double nearest = 10, furthest = 10;
    for (int step = 0; step < 60 * 63; step++) {
        must(world.step(1.0 / 60));
        const double r = length(position_of(world, planet));
        nearest = minimum(nearest, r), furthest = maximum(furthest, r);
    }
    EXPECT_NEAR(nearest, 10, 2e-3);
    EXPECT_NEAR(furthest, 10, 2e-3);
}

TEST(ForceFields, vortex_rotates_bodies_by_the_right_hand_rule) {
    World world = make_world({.gravity = {}});
    const BodyId ball = add(world, {.geometry = Sphere{0.1}, .position = {2, 0, 0}});
    must(world.create_field({.force = VortexField{.strength = 6, .lift = 2, .per_mass = true}}));
    must(world.step(1.0 / 60));
    // 3 m/s^2 towards y x x = -z, 1 m/s^2 up.
    EXPECT_TRUE(near(velocity_of(world, ball) * 60, {0, 1, -3}, 1e-3));
}

TEST(ForceFields, act_only_in_their_region_and_on_their_categories) {
    World world = make_world({.gravity = {}});
    const BodyId inside = add(world, {}), outside = add(world, {.position = {20, 0, 0}});
    const BodyId other = must(world.create_body({.pose = {{0, 3, 0}, {}}},
                                                {.geometry = Box{}, .filter = {.category = 4}}));
    must(world.create_field({.force = UniformWind{.velocity = {0, 0, 9}},
                             .region = Aabb{{-5, -5, -5}, {5, 5, 5}},
                             .mask = 1}));
    run(world, 0.5);
    EXPECT_GT(velocity_of(world, inside).z, 0);
    EXPECT_EQ(velocity_of(world, outside).z, 0);
    EXPECT_EQ(velocity_of(world, other).z, 0);
}

// Heavy and light cubes float upright, submerged by their share of the water's density. (Those
// between 0.21 and 0.79 of it lean.)
TEST(ForceFields, wood_floats_at_the_analytic_depth) {
    for (const double density : {900.0, 100.0}) {
        World world = make_world();
        const BodyId cube =
            add(world, {.position = {0, 1, 0}, .density = density, .sleep_allowed = false});
        must(world.create_field({.force = BuoyancyField{.drag = 40, .angular_drag = 5}}));
        run(world, 30);
        EXPECT_NEAR(position_of(world, cube).y, 0.5 - density / 1000, 2e-3);
        // What is quadratic lets them bob on ever less, as 1 / t.
        EXPECT_NEAR(length(velocity_of(world, cube)), 0, 5e-3);
    }
}

// A log of capsule shape lies down; a raft of boxes that touch is a solved island in water.
TEST(ForceFields, log_tips_over_and_a_stack_of_planks_floats) {
    World world = make_world();
    const BodyId log = add(world, {.geometry = Capsule{0.2, 1},
                                   .position = {0, 0.4, 0},
                                   .rotation = from_axis_angle({0, 0, 1}, 0.1),
                                   .density = 600});
    const BodyId low =
        add(world, {.geometry = Box{{1, 0.1, 1}}, .position = {5, 0.1, 0}, .density = 300});
    const BodyId high =
        add(world, {.geometry = Box{{0.4, 0.1, 0.4}}, .position = {5, 0.3, 0}, .density = 300});
    must(world.create_field({.force = BuoyancyField{.angular_drag = 2}}));
    run(world, 40);
    const Vec3 along = rotate(state_of(world, log).pose.rotation, {0, 1, 0});
    EXPECT_NEAR(along.y, 0, 0.05) << "upright is the unstable way to float";
    // 300 kg/m^3 of .8 + .128 m^3 in water over 4 m^2.
    const double draught = 0.3 * (0.8 + 0.128) / 4;
    EXPECT_NEAR(position_of(world, low).y, 0.1 - draught, 2e-3);
    EXPECT_NEAR(position_of(world, high).y - position_of(world, low).y, 0.2, 2e-3);
}

TEST(ForceFields, steady_wind_does_not_wake_bodies_and_a_change_does) {
    World world = make_world();
    add_floor(world);
    const BodyId crate = add(world, {.position = {0, 0.5, 0}});
    const FieldId wind = must(world.create_field({.force = UniformWind{.velocity = {3, 0, 0}}}));
    run(world, 3);
    EXPECT_FALSE(state_of(world, crate).awake);
    must(world.set_field(wind, {.force = UniformWind{.velocity = {4, 0, 0}}}));
    EXPECT_TRUE(state_of(world, crate).awake);
    run(world, 3);
    EXPECT_FALSE(state_of(world, crate).awake);
    must(world.destroy_field(wind));
    EXPECT_TRUE(state_of(world, crate).awake);
}

TEST(ForceFields, bodies_in_gusts_do_not_fall_asleep) {
    World world = make_world();
    add_floor(world);
    const BodyId crate = add(world, {.position = {0, 0.5, 0}});
    must(world.create_field({.force = UniformWind{.gust = {3, 0, 0}, .gust_period = 4}}));
    run(world, 3);
    EXPECT_TRUE(state_of(world, crate).awake);
}

TEST(ForceFields, are_bit_identical_for_any_thread_count_and_after_load) {
    const auto make = [](int threads) {
        World world = make_world({.threads = threads});
        add_floor(world);
        for (int k = 0; k < 60; k++)
            add(world,
                {.position = {0.3 * (k % 5), 1 + 1.1 * (k / 5), 0.2 * (k % 3)}, .density = 400});
        must(world.create_field({.force = BuoyancyField{.offset = 4}}));
        must(world.create_field({.force = UniformWind{.velocity = {5, 0, 0}, .gust = {0, 0, 4}}}));
        must(world.create_field({.force = VortexField{.strength = 20}}));
        return world;
    };
    World one = make(1), four = make(4);
    run(one, 1);
    run(four, 1);
    ASSERT_EQ(state_hash(one), state_hash(four));
    World loaded = must(load(save(one)));
    EXPECT_EQ(first_difference(one, loaded), std::nullopt);
    run(one, 1);
    run(loaded, 1);
    EXPECT_EQ(state_hash(one), state_hash(loaded));
}

}  // namespace
}  // namespace jostle::test
