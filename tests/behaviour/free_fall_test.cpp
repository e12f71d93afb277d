// SPDX-License-Identifier: MIT
//
// A body in flight follows its parabola: constant force is integrated exactly, whatever the step.
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

}  // namespace
}  // namespace jostle::test
