// SPDX-License-Identifier: MIT
//
// What slides comes to rest after v^2 / (2 mu g), in any direction.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

const Vec3 along{0.86602540378443865, 0, 0.5};  // azimuth 30 degrees

TEST(Friction, box_slides_the_coulomb_distance) {
    World world = make_world();
    add_floor(world, 0.4);
    const BodyId box = add(world, {.geometry = Box{{0.5, 0.05, 0.5}},
                                   .position = {0, 0.05, 0},
                                   .velocity = along * 5,
                                   .friction = 0.4});
    run(world, 3);
    const double distance = 25 / (2 * 0.4 * 9.81);  // 3.1855 m
    const Vec3 p = position_of(world, box);
    RecordProperty("relative_error", std::to_string(dot(p, along) / distance - 1));
    EXPECT_TRUE(near({p.x, 0, p.z}, along * distance, 0.01 * distance));
    EXPECT_LT(length(velocity_of(world, box)), 1e-3);
}

TEST(Friction, pair_uses_the_geometric_mean) {
    World world = make_world();
    add_floor(world, 0.8);
    const BodyId box = add(world, {.geometry = Box{{0.5, 0.05, 0.5}},
                                   .position = {0, 0.05, 0},
                                   .velocity = along * 3,
                                   .friction = 0.2});
    run(world, 3);
    const double distance = 9 / (2 * 0.4 * 9.81);
    EXPECT_NEAR(dot(position_of(world, box), along), distance, 0.01 * distance);
}

// Slides until the surface has caught up, at t = 2 v / (7 mu g), then rolls with 5/7 of the speed.
TEST(Friction, sliding_ball_transitions_to_rolling) {
    World world = make_world();
    add_floor(world, 0.3);
    const BodyId ball = add(
        world,
        {.geometry = Sphere{0.1}, .position = {0, 0.1, 0}, .velocity = along * 5, .friction = 0.3});
    run(world, 2);
    const Vec3 p = position_of(world, ball);
    RecordProperty("distance_m", std::to_string(dot(p, along)));
    EXPECT_TRUE(near({p.x, 0, p.z}, along * 7.4895810, 0.01 * 7.49));
    EXPECT_NEAR(length(velocity_of(world, ball)), 25.0 / 7, 0.01 * 25 / 7);
    // Rolling: the lowest point is at rest.
    const BodyState s = state_of(world, ball);
    EXPECT_LT(length(s.linear_velocity + cross(s.angular_velocity, {0, -0.1, 0})), 0.01);
}

// Each ring of the ground face brakes with mu p r: a spinning box stops in finite time and does not
// wander.
TEST(Friction, spinning_box_stops_in_place) {
    World world = make_world();
    add_floor(world, 0.5);
    const BodyId box = add(
        world, {.geometry = Box{{0.5, 0.05, 0.5}}, .position = {0, 0.05, 0}, .spin = {0, 10, 0}});
    run(world, 3);
    const Vec3 p = position_of(world, box);
    EXPECT_LT(length({p.x, 0, p.z}), 0.02);
    EXPECT_LT(length(state_of(world, box).angular_velocity), 1e-3);
}

// A floor of separate tiles that lie flush: a crate does not catch on their seams, but on a tile
// that stands one centimetre higher.
TEST(Friction, crate_slides_over_seams_but_not_over_a_kerb) {
    for (const bool planar : {false, true})
        for (const double speed : {0.5, 3.0, 10.0, 30.0})
            for (const double kerb : {0.0, 0.01}) {
                World world = make_world({.planar = planar});
                const auto tile = [&](double at, double height) {
                    add(world, {.geometry = Box{{0.5, 0.5, 2}},
                                .position = {at, height - 0.5, 0},
                                .friction = 0.2,
                                .type = BodyType::static_body});
                };
                // The kerb begins with a tile that the crate comes to before half of the way.
                const int steps = speed < 1 ? 12 : 60;
                const double time = steps / 60.0;
                const double way = speed * time - 0.1 * 9.81 * time * time;
                for (int i = -2; i < way + 2; i++) tile(i + 0.73, i > 0.4 * way - 0.5 ? kerb : 0);
                const BodyId crate = add(
                    world,
                    {.geometry = Box{{0.2, 0.2, 0.2}}, .position = {0, 0.2, 0}, .friction = 0.2});
                run(world, 0.1);
                must(world.set_velocity(crate, {speed, 0, 0}, {}));
                double top = 0;
                for (int i = 0; i < steps; i++) {
                    must(world.step(1.0 / 60));
                    top = maximum(top, position_of(world, crate).y);
                }
                const double left = velocity_of(world, crate).x, wished = speed - 0.2 * 9.81 * time;
                const auto where = std::to_string(speed) + (planar ? " m/s, planar" : " m/s");
                if (kerb == 0) {
                    EXPECT_NEAR(left, wished, 0.01 * speed) << where;
                    EXPECT_NEAR(top, 0.2, 1e-3) << where;
                } else {
                    EXPECT_LT(left, wished - 0.1 * speed) << where;
                }
            }
}

// Coulomb's distance at any rate, along no axis: what a box that is put down at zero gap loses
// before its weight is felt may not grow with the rate.
TEST(Friction, stopping_distance_is_independent_of_the_step_rate) {
    const double distance = 25 / (2 * 0.4 * 9.81);
    double before = 1;
    for (const double hz : {60.0, 120.0, 240.0, 480.0, 960.0}) {
        World world = make_world();
        add_floor(world, 0.4);
        const BodyId box = add(world, {.geometry = Box{{0.5, 0.05, 0.5}},
                                       .position = {0, 0.05, 0},
                                       .velocity = along * 5,
                                       .friction = 0.4});
        run(world, 2, hz);
        const Vec3 p = position_of(world, box);
        const double error = length(Vec3{p.x, 0, p.z} - along * distance) / distance;
        EXPECT_LT(error, 2.5e-3) << hz;
        EXPECT_LT(error, before) << hz;
        before = error;
    }
}

// On a slope of 0.3 with a friction of 0.2 it slides by half of (sine - 0.2 cosine) g t^2.
TEST(Friction, sliding_speed_is_independent_of_the_step_rate) {
    const double cosine = 1 / std::sqrt(1.09), way = 0.5 * 9.81 * (0.3 - 0.2) * cosine * 4;
    for (const double hz : {60.0, 120.0, 240.0, 480.0, 960.0}) {
        World world = make_world({.gravity = leaning_gravity(0.3, pi / 6)});
        add_floor(world, 0.2);
        const BodyId box = add(
            world, {.geometry = Box{{0.5, 0.25, 0.5}}, .position = {0, 0.25, 0}, .friction = 0.2});
        run(world, 2, hz);
        const Vec3 p = position_of(world, box);
        EXPECT_NEAR(std::hypot(p.x, p.z) / way, 1, 1e-3) << hz;
    }
}

}  // namespace
}  // namespace jostle::test
