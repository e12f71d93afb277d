// SPDX-License-Identifier: MIT
#include "host/drag_spring.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace jostle::server {
namespace {

using namespace physics;

constexpr double dt = 1.0 / 60;

struct Held {
    const char* what;
    ShapeDef shape;
    Vec3 anchor;  // in the body
};

// From a feather of a tenth of a gram to 80 tonnes, held by the middle, by a corner, by a far
// point.
std::vector<Held> held_bodies() {
    return {
        {"feather", {.geometry = Sphere{0.05}, .density = 0.2}, {0, 0.05, 0}},
        {"ball by its middle", {.geometry = Sphere{0.5}}, {}},
        {"box by a corner", {.geometry = Box{}}, {0.5, 0.5, 0.5}},
        {"long thin rod by its end", {.geometry = Capsule{0.05, 2}, .density = 7800}, {0, 2.05, 0}},
        {"80 tonnes by a corner", {.geometry = Box{{1, 1, 1}}, .density = 10000}, {1, 1, 1}},
    };
}

World weightless() {
    return std::move(*World::create({.gravity = {}}));
}

Vec3 held_point(const World& world, const DragSpring& spring) {
    return apply(world.body(spring.body)->pose, spring.anchor);
}

TEST(DragSpring, brings_any_mass_to_the_hand_and_stops_there) {
    for (const Held& held : held_bodies()) {
        SCOPED_TRACE(held.what);
        World world = weightless();
        DragSpring spring{*world.create_body({}, held.shape), held.anchor, {}};
        spring.target = held.anchor + Vec3{0.5, -0.25, 0.25};
        double furthest = length(spring.target - held.anchor);
        const double begin = furthest;
        for (int tick = 0; tick < 600; tick++) {
            ASSERT_TRUE(pull(world, spring, dt).ok());
            ASSERT_TRUE(world.step(dt).ok());
            furthest = std::max(furthest, length(held_point(world, spring) - spring.target));
        }
        // Critically damped: the point never gets further away than it was. The swing of the body
        // about the hand takes longest: a box held by its corner loses it at 0.7 a second.
        EXPECT_LE(furthest, begin * 1.05);
        EXPECT_LT(length(held_point(world, spring) - spring.target), 0.005);
        EXPECT_LT(length(world.body(spring.body)->linear_velocity), 0.01);
    }
}

TEST(DragSpring, a_hand_that_jumps_about_never_makes_a_body_run_away) {
    std::vector<Held> all = held_bodies();
    all.push_back({"ball by a point 100 m away", {.geometry = Sphere{0.3}}, {100, 0, 0}});
    for (const Held& held : all) {
        SCOPED_TRACE(held.what);
        World world = weightless();
        DragSpring spring{*world.create_body({}, held.shape), held.anchor, held.anchor};
        double fastest = 0;
        for (int tick = 0; tick < 1200; tick++) {
            // 10 m to and fro, fifteen times a second: no human hand, but any client may send it.
            spring.target = held.anchor + Vec3{tick / 2 % 2 ? 10.0 : 0.0, 0, 0};
            ASSERT_TRUE(pull(world, spring, dt).ok());
            ASSERT_TRUE(world.step(dt).ok());
            fastest = std::max(fastest, length(world.body(spring.body)->linear_velocity));
        }
        // 200 m/s^2 for two ticks each way, and what a spring of 10 m gives at most: 10 m * omega.
        EXPECT_LT(fastest, 10 * 2 * pi * 5);
        EXPECT_TRUE(is_finite(world.body(spring.body)->pose));
        // The hand holds still again: so does the body.
        spring.target = held.anchor;
        for (int tick = 0; tick < 600; tick++) {
            ASSERT_TRUE(pull(world, spring, dt).ok());
            ASSERT_TRUE(world.step(dt).ok());
        }
        EXPECT_LT(length(held_point(world, spring) - spring.target), 0.01);
    }
}

TEST(DragSpring, pulls_no_harder_than_200_metres_per_second_squared) {
    for (const double density : {1.0, 20000.0}) {
        World world = weightless();
        const BodyId body = *world.create_body({}, {.geometry = Sphere{0.5}, .density = density});
        ASSERT_TRUE(pull(world, {body, {}, {9000, 0, 0}}, dt).ok());
        EXPECT_NEAR(world.body(body)->linear_velocity.x, 200 * dt, 1e-9) << density;
    }
}

TEST(DragSpring, a_body_that_is_gone_is_an_error_and_a_fixed_one_stays) {
    World world = weightless();
    const BodyId wall = *world.create_body({.type = BodyType::static_body}, {.geometry = Box{}});
    EXPECT_TRUE(pull(world, {wall, {}, {5, 0, 0}}, dt).ok());
    EXPECT_EQ(world.body(wall)->pose.position, (Vec3{}));
    ASSERT_TRUE(world.destroy_body(wall).ok());
    EXPECT_FALSE(pull(world, {wall, {}, {5, 0, 0}}, dt).ok());
}

}  // namespace
}  // namespace jostle::server
