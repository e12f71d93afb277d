// SPDX-License-Identifier: MIT
//
// On a slope of atan(0.3) toward an azimuth of 30 degrees: what sticks, what slides and what rolls,
// as Coulomb says. The azimuth matters: a friction pyramid is right along its axes only.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace jostle::test
