// SPDX-License-Identifier: MIT
//
// Coulomb friction. On a slope of atan(0.3) toward an azimuth of 30 degrees bodies stick, slide or
// roll as Coulomb's law predicts; a friction pyramid would be right along its axes only. On a level
// floor a sliding body stops after v^2 / (2 mu g) in any direction.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {

namespace {
using namespace physics;

constexpr double slope = 0.3;
constexpr double azimuth = pi / 6;

Vec3 downhill() {
    const SinCos a = sin_cos(azimuth);
    return {a.cos, 0, a.sin};
}
// Of gravity: along the slope, and the pull into it.
double g_along() {
    return 9.81 * slope / square_root(1 + slope * slope);
}
double g_into() {
    return 9.81 / square_root(1 + slope * slope);
}

World incline(double friction, bool sleeping = true) {
    World world = make_world({.gravity = leaning_gravity(slope, azimuth), .sleeping = sleeping});
    add_floor(world, friction);
    return world;
}

TEST(Incline, box_sticks_when_friction_is_above_the_slope) {
    World world = incline(0.5, false);
    const BodyId box =
        add(world, {.geometry = Box{{0.5, 0.25, 0.5}}, .position = {0, 0.25, 0}, .friction = 0.5});
    run(world, 5);
    const Vec3 p = position_of(world, box);
    const double creep = length({p.x, 0, p.z});
    RecordProperty("creep_um", std::to_string(creep * 1e6));
    EXPECT_LT(creep, 1e-3);
}

TEST(Incline, box_just_above_the_friction_limit_sticks) {
    World world = incline(0.31, false);
    const BodyId box =
        add(world, {.geometry = Box{{0.5, 0.25, 0.5}}, .position = {0, 0.25, 0}, .friction = 0.31});
    run(world, 5);
    const Vec3 p = position_of(world, box);
    EXPECT_LT(length({p.x, 0, p.z}), 1e-3);
}

TEST(Incline, box_slides_at_the_coulomb_acceleration_below_the_friction_limit) {
    World world = incline(0.2);
    const BodyId box =
        add(world, {.geometry = Box{{0.5, 0.25, 0.5}}, .position = {0, 0.25, 0}, .friction = 0.2});
    run(world, 2);
    const double distance = 0.5 * (g_along() - 0.2 * g_into()) * 4;  // 1.8793 m
    const Vec3 p = position_of(world, box);
    RecordProperty("relative_error", std::to_string(dot(p, downhill()) / distance - 1));
    EXPECT_TRUE(near({p.x, 0, p.z}, downhill() * distance, 0.01 * distance));
}

// Contacts are integrated by sub-steps of 1/480 s: the way is long by half of one in 2 s.
TEST(Incline, frictionless_box_accelerates_by_gravity_along_the_slope) {
    World world = incline(0);
    const BodyId box = add(world, {.position = {0, 0.5, 0}, .friction = 0});
    run(world, 2);
    const double distance = 0.5 * g_along() * 4;
    const Vec3 p = position_of(world, box);
    EXPECT_TRUE(near({p.x, 0, p.z}, downhill() * distance, 2e-3 * distance));
}

TEST(Incline, sphere_rolls_at_five_sevenths_of_the_acceleration) {
    World world = incline(0.5);
    const BodyId ball = add(world, {.geometry = Sphere{0.2}, .position = {0, 0.2, 0}});
    run(world, 2);
    const double distance = 0.5 * 5.0 / 7 * g_along() * 4;
    const Vec3 p = position_of(world, ball);
    RecordProperty("relative_error", std::to_string(dot(p, downhill()) / distance - 1));
    EXPECT_TRUE(near({p.x, 0, p.z}, downhill() * distance, 0.01 * distance));
}

// a = g sin / (1 + I / (m r^2)), I about the capsule's axis.
TEST(Incline, capsule_rolls_about_its_axis) {
    World world = incline(0.5);
    const double r = 0.2, half = 0.4;
    const Vec3 axis = cross({0, 1, 0}, downhill());
    const Quat lying = from_rotation_vector(cross({0, 1, 0}, axis) * (pi / 2));
    const BodyId capsule =
        add(world, {.geometry = Capsule{r, half}, .position = {0, r, 0}, .rotation = lying});
    run(world, 2);
    const double cylinder = pi * r * r * 2 * half, balls = 4.0 / 3 * pi * r * r * r;
    const double ratio = (0.5 * cylinder + 0.4 * balls) / (cylinder + balls);
    const double distance = 0.5 * g_along() / (1 + ratio) * 4;
    const Vec3 p = position_of(world, capsule);
    RecordProperty("relative_error", std::to_string(dot(p, downhill()) / distance - 1));
    EXPECT_TRUE(near({p.x, 0, p.z}, downhill() * distance, 0.01 * distance));
}

// The same law on a slope that is a body turned in space.
TEST(Incline, box_slides_down_a_tilted_static_box) {
    World world = make_world();
    const Quat tilt = from_rotation_vector(cross(downhill(), {0, -1, 0}) * std::atan(slope));
    add(world, {.geometry = Box{{20, 1, 20}},
                .position = rotate(tilt, {0, -1, 0}),
                .rotation = tilt,
                .friction = 0.2,
                .type = BodyType::static_body});
    const BodyId box = add(world, {.geometry = Box{{0.5, 0.25, 0.5}},
                                   .position = rotate(tilt, {0, 0.25, 0}),
                                   .rotation = tilt,
                                   .friction = 0.2});
    run(world, 2);
    const double distance = 0.5 * (g_along() - 0.2 * g_into()) * 4;
    const Vec3 moved = position_of(world, box) - rotate(tilt, {0, 0.25, 0});
    EXPECT_TRUE(near(moved, rotate(tilt, downhill()) * distance, 0.01 * distance));
}

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

// A base that is not square answers a push along one axis with another tilt than along the other.
// Friction opposes the motion all the same (a plank ended 0.41 m to the side of a way of 3.19 m).
TEST(Friction, bases_of_any_shape_slide_straight) {
    std::vector<Vec3> prism;
    for (int i = 0; i < 7; i++) {
        const SinCos a = sin_cos(2 * pi * i / 7);
        for (const double y : {-0.15, 0.15}) prism.push_back({0.6 * a.cos, y, 0.25 * a.sin});
    }
    const std::vector<Vec3> wedge = {{-0.5, -0.1, -0.2}, {0.5, -0.1, -0.2}, {-0.5, -0.1, 0.2},
                                     {0.5, -0.1, 0.1},   {-0.5, 0.2, -0.2}, {-0.5, 0.2, 0.2},
                                     {-0.2, 0.2, 0.1}};
    struct Base {
        Geometry geometry;
        double height;
    };
    const Base bases[] = {{Box{{0.45, 0.1, 0.15}}, 0.1},
                          {Box{{1, 0.05, 0.1}}, 0.05},
                          {Box{{0.3, 0.3, 0.15}}, 0.3},
                          {Hull{*build_hull(prism)}, 0.15},
                          {Hull{*build_hull(wedge)}, 0.1},
                          {Cylinder{0.3, 0.1}, 0.1},
                          {Cone{0.3, 0.1}, 0.1}};
    double worst = 0, worst_path = 0;
    for (const Base& base : bases)
        for (const double yaw : {0.3, 0.8, 1.3, 2.1, 2.8})
            for (const double hz : {30.0, 60.0, 240.0}) {
                World world = make_world({.sleeping = false});
                add_floor(world, 0.4);
                const BodyId body = add(world, {.geometry = base.geometry,
                                                .position = {0, base.height, 0},
                                                .rotation = from_axis_angle({0, 1, 0}, yaw),
                                                .velocity = along * 5,
                                                .friction = 0.4});
                run(world, 1.7, hz);
                const double distance = 25 / (2 * 0.4 * 9.81);
                const Vec3 p = position_of(world, body);
                worst = maximum(worst, absolute(along.x * p.z - along.z * p.x) / distance);
                worst_path = maximum(worst_path, absolute(dot(p, along) / distance - 1));
            }
    RecordProperty("sideways", std::to_string(worst));
    EXPECT_LT(worst, 1e-4);
    EXPECT_LT(worst_path, 0.005);
}

// The impulse that pushes an overlap apart is no load: with 6 mm at the start the box stopped after
// 2.25, 1.27 and 0.12 m at 60, 240 and 960 Hz.
TEST(Friction, overlap_at_the_start_does_not_shorten_the_way) {
    for (const bool planar : {false, true})
        for (const double overlap : {0.001, 0.006, 0.02})
            for (const double hz : {30.0, 60.0, 240.0, 960.0}) {
                World world = make_world({.sleeping = false, .planar = planar});
                add_static(world,
                           {.geometry = Box{{9, 1, 9}}, .position = {0, -1, 0}, .friction = 0.25});
                const BodyId box = add(world, {.geometry = Box{{0.25, 0.25, 0.25}},
                                               .position = {0, 0.25 - overlap, 0},
                                               .velocity = {4, 0, 0},
                                               .friction = 0.25});
                run(world, 2, hz);
                const double distance = 16 / (2 * 0.25 * 9.81);
                EXPECT_NEAR(position_of(world, box).x, distance, 0.016 * distance)
                    << overlap << " m at " << hz << " Hz" << (planar ? ", planar" : "");
            }
}

// What is thrown across a conveyor slides straight in the frame of its surface.
TEST(Friction, plank_on_a_conveyor_slides_along_the_relative_velocity) {
    for (const double yaw : {0.0, 0.5, 0.8}) {
        World world = make_world({.sleeping = false});
        must(world.create_body({.type = BodyType::static_body, .pose = {.position = {0, -1, 0}}},
                               {.geometry = Box{{50, 1, 50}},
                                .material = {.friction = 0.3, .surface_velocity = {2, 0, 0}}}));
        const BodyId plank = add(world, {.geometry = Box{{0.45, 0.1, 0.15}},
                                         .position = {0, 0.1, 0},
                                         .rotation = from_axis_angle({0, 1, 0}, yaw),
                                         .velocity = {0, 0, 3},
                                         .friction = 0.3});
        run(world, 3);
        const double speed = square_root(13), slide = 13 / (2 * 0.3 * 9.81);
        const Vec3 p = position_of(world, plank);
        EXPECT_NEAR(p.x, 2 * 3 - 2 / speed * slide, 0.01);
        EXPECT_NEAR(p.z, 3 / speed * slide, 0.01);
    }
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
