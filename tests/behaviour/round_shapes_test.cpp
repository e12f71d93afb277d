// SPDX-License-Identifier: MIT
//
// Spheres and capsules rest on their lowest point, roll without slipping, and fall over when they
// must.
#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

const Quat lying{0, 0, 0.70710678118654757, 0.70710678118654757};  // the capsule's axis along x

TEST(RoundShapes, rest_at_the_height_of_their_radius) {
    World world = make_world();
    add_floor(world);
    const BodyId ball = add(world, {.geometry = Sphere{0.3}, .position = {0, 0.3, 0}});
    const BodyId capsule =
        add(world, {.geometry = Capsule{0.2, 0.5}, .position = {3, 0.2, 0}, .rotation = lying});
    run(world, 3);
    EXPECT_TRUE(near(position_of(world, ball), {0, 0.3, 0}, 1e-3));
    EXPECT_TRUE(near(position_of(world, capsule), {3, 0.2, 0}, 1e-3));
    EXPECT_EQ(world.summary().awake_bodies, 0);
}

TEST(RoundShapes, rest_on_boxes_and_on_each_other) {
    World world = make_world();
    add(world,
        {.geometry = Box{{5, 0.5, 5}}, .position = {0, -0.5, 0}, .type = BodyType::static_body});
    const BodyId capsule =
        add(world, {.geometry = Capsule{0.2, 0.5}, .position = {0, 0.2, 0}, .rotation = lying});
    const BodyId box = add(world, {.geometry = Box{{0.4, 0.1, 0.6}}, .position = {3, 0.1, 0}});
    const BodyId ball = add(world, {.geometry = Sphere{0.3}, .position = {3, 0.5, 0}});
    run(world, 3);
    EXPECT_TRUE(near(position_of(world, capsule), {0, 0.2, 0}, 1e-3));
    EXPECT_TRUE(near(position_of(world, box), {3, 0.1, 0}, 1e-3));
    EXPECT_TRUE(near(position_of(world, ball), {3, 0.5, 0}, 2e-3));
}

TEST(RoundShapes, rolling_ball_keeps_its_speed) {
    World world = make_world();
    add_floor(world);
    const double r = 0.2, v = 2;
    const BodyId ball = add(world, {.geometry = Sphere{r},
                                    .position = {0, r, 0},
                                    .velocity = {v, 0, 0},
                                    .spin = {0, 0, -v / r}});
    run(world, 5);
    const BodyState s = state_of(world, ball);
    EXPECT_TRUE(near(s.pose.position, {10, r, 0}, 0.1));
    EXPECT_NEAR(s.linear_velocity.x, v, 0.02);
    EXPECT_NEAR(s.angular_velocity.z, -s.linear_velocity.x / r, 0.01);
}

TEST(RoundShapes, upright_capsule_falls_over_when_nudged) {
    World world = make_world();
    add_floor(world);
    const BodyId capsule =
        add(world, {.geometry = Capsule{0.2, 0.6}, .position = {0, 0.8, 0}, .spin = {0, 0, -0.2}});
    run(world, 6);
    EXPECT_NEAR(position_of(world, capsule).y, 0.2, 2e-3);
}

TEST(RoundShapes, ball_comes_to_rest_in_a_corner) {
    World world = make_world();
    add_floor(world);
    for (const Vec3 n : {Vec3{1, 0, 0}, Vec3{0, 0, 1}})
        add(world, {.geometry = Plane{n}, .type = BodyType::static_body});
    const BodyId ball =
        add(world, {.geometry = Sphere{0.3}, .position = {1, 1, 1}, .velocity = {-3, 0, -2}});
    run(world, 5);
    const Vec3 p = position_of(world, ball);
    EXPECT_GT(p.x, 0.298);
    EXPECT_NEAR(p.y, 0.3, 2e-3);
    EXPECT_GT(p.z, 0.298);
}

}  // namespace
}  // namespace jostle::test
