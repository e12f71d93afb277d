// SPDX-License-Identifier: MIT
//
// Ground detection of wheels on all kinds of static and moving ground.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

using modules::WheelCast;

constexpr WheelCast casts[] = {WheelCast::ray, WheelCast::sphere, WheelCast::cylinder};

// The front wheels, at z = -1.35, are 0.15 m in front of a kerb of 0.1 m, whose edge touches wheels
// of 0.33 m.
TestCar before_a_kerb(WheelCast cast) {
    TestCar of;
    of.world
        .create_body({.type = BodyType::static_body, .pose = {.position = {0, 0.05, -4.5}}},
                     {.geometry = Box{{5, 0.05, 3}}, .material = {.friction = 1}})
        .value();
    VehicleDef def = plain_saloon(of.chassis);
    def.cast = cast;
    for (auto& wheel : def.wheels) wheel.hand_brake_torque = 5000;
    of.add(def);
    of.set({.hand_brake = 1, .gear = 0});
    of.drive(3);
    return of;
}

TEST(Ground, wheel_cast_finds_a_kerb_edge_that_a_ray_misses) {
    const TestCar by_ray = before_a_kerb(WheelCast::ray);
    EXPECT_NEAR(by_ray.body().pose.rotation.x, 0, 1e-6);
    for (const WheelCast cast : {WheelCast::sphere, WheelCast::cylinder}) {
        const TestCar of = before_a_kerb(cast);
        const auto wheel = of.state().wheels[0];
        EXPECT_NEAR(wheel.point.y, 0.1, 1e-3);
        EXPECT_NEAR(wheel.point.z, -1.5, 1e-3);
        EXPECT_GT(wheel.normal.z, 0.3) << "the force points up and back";
        EXPECT_GT(wheel.normal.y, 0.7);
        EXPECT_GT(of.body().pose.rotation.x, 0.005) << "the nose is up";
        EXPECT_LT(of.speed(), 1e-3);
    }
}

TEST(Ground, car_climbs_a_kerb_of_half_its_wheel_radius) {
    TestCar of({}, {0, 0, -4});
    of.world
        .create_body({.type = BodyType::static_body, .pose = {.position = {0, 0.08, -20}}},
                     {.geometry = Box{{5, 0.08, 15}}, .material = {.friction = 1}})
        .value();
    of.add(plain_saloon(of.chassis));
    of.set({.throttle = 0.4});
    of.drive(5);
    EXPECT_LT(of.body().center.z, -8);
    EXPECT_NEAR(of.body().center.y, 0.67 + 0.16, 0.08) << "it is on the kerb";
}

TEST(Ground, lift_carries_a_parked_car) {
    for (const WheelCast cast : casts) {
        TestCar of;
        const BodyId lift =
            of.world
                .create_body({.type = BodyType::kinematic, .pose = {.position = {0, 0.2, 0}}},
                             {.geometry = Box{{4, 0.2, 4}}, .material = {.friction = 1}})
                .value();
        of.world.set_pose(of.chassis, {.position = {0, 1.1, 0}}).expect();
        VehicleDef def = plain_saloon(of.chassis);
        def.cast = cast;
        of.add(def);
        of.set({.hand_brake = 1, .gear = 0});
        of.drive(4);
        const Vec3 start = of.body().center;
        of.world.set_velocity(lift, {0.5, 1, 0}, {}).expect();
        of.drive(4);
        const Vec3 displacement = of.body().center - start;
        EXPECT_NEAR(displacement.y, 4, 0.02);
        EXPECT_NEAR(displacement.x, 2, 0.02) << "the tread carries it along";
        EXPECT_NEAR(of.load({0, 1, 2, 3}), car_mass * gravity, 0.01 * car_mass * gravity);
    }
}

TEST(Ground, turntable_turns_a_parked_car) {
    TestCar of;
    const BodyId table =
        of.world
            .create_body({.type = BodyType::kinematic, .pose = {.position = {0, 0.2, 0}}},
                         {.geometry = Cylinder{4, 0.2}, .material = {.friction = 1}})
            .value();
    of.world.set_pose(of.chassis, {.position = {0, 1.1, 0}}).expect();
    VehicleDef def = plain_saloon(of.chassis);
    for (auto& wheel : def.wheels) wheel.hand_brake_torque = 5000;
    of.add(def);
    of.set({.hand_brake = 1, .gear = 0});
    of.drive(3);
    of.world.set_velocity(table, {}, {0, 0.5, 0}).expect();
    of.drive(5);
    EXPECT_NEAR(of.body().angular_velocity.y, 0.5, 0.005);
    const Quat of_car = of.body().pose.rotation, of_table = of.world.body(table)->pose.rotation;
    const Quat off = conjugate(of_table) * of_car;
    EXPECT_NEAR(2 * std::abs(off.y), 0, 0.02) << "rad";
}

// A barge that rests on the ground is in another sub-step group than the car.
TEST(Ground, ground_body_carries_the_weight_of_the_car) {
    TestCar of;
    const BodyId barge =
        of.world
            .create_body({.pose = {.position = {0, 0.2, 0}}},
                         {.geometry = Box{{4, 0.2, 4}}, .material = {.friction = 1}, .mass = 3000})
            .value();
    of.world.set_pose(of.chassis, {.position = {0, 1.1, 0}}).expect();
    of.add(plain_saloon(of.chassis));
    of.set({.hand_brake = 1, .gear = 0});
    of.drive(6);
    EXPECT_NEAR(of.load({0, 1, 2, 3}), car_mass * gravity, 0.01 * car_mass * gravity);
    EXPECT_LT(length(of.world.body(barge)->linear_velocity), 0.05);
    EXPECT_NEAR(of.world.body(barge)->pose.position.y, 0.2, 0.01);
}

// Both float in one group, and momentum is conserved up to rounding.
TEST(Ground, car_on_a_free_raft_applies_equal_reaction) {
    TestCar of({.gravity = {}});
    const BodyId raft =
        of.world
            .create_body({.pose = {.position = {0, 50, 0}}},
                         {.geometry = Box{{4, 0.2, 20}}, .material = {.friction = 1}, .mass = 6000})
            .value();
    of.world.set_pose(of.chassis, {.position = {0, 50.9, 0}}).expect();
    of.world.set_velocity(of.chassis, {0, -0.5, 0}, {}).expect();
    VehicleDef def = plain_saloon(of.chassis);
    of.add(def);
    const WorldSummary before = of.world.summary();
    of.set({.throttle = 1});
    double pushed = 0;
    for (int k = 0; k < 60; k++) {
        of.drive(step_time);
        pushed = std::max(pushed, length(of.world.body(raft)->linear_velocity));
    }
    EXPECT_GT(pushed, 0.05) << "the car pushes the raft";
    const double off = length(of.world.summary().linear_momentum - before.linear_momentum);
    RecordProperty("momentum_off_kg_m_s", std::to_string(off));
    EXPECT_LT(off, 1e-6);
}

TEST(Ground, wheels_ignore_categories_outside_the_ground_mask) {
    TestCar of;
    VehicleDef def = plain_saloon(of.chassis);
    def.ground = 2;  // the plane has category 1
    of.add(def);
    of.drive(2);
    EXPECT_EQ(of.load({0, 1, 2, 3}), 0);
    EXPECT_LT(of.body().center.y, 0.3) << "the chassis has fallen to the ground";
}

TEST(Ground, flat_mesh_drives_like_a_plane) {
    for (const WheelCast cast : casts) {
        TestCar of({}, {0, 0, -10});
        std::vector<Vec3> vertices;
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (std::uint32_t row = 0; row <= 40; row++)
            for (std::uint32_t column = 0; column <= 4; column++)
                vertices.push_back({column * 2.0 - 4, 1, 10 - row * 2.0});
        for (std::uint32_t row = 0; row < 40; row++)
            for (std::uint32_t column = 0; column < 4; column++) {
                const std::uint32_t a = row * 5 + column, b = a + 5;
                triangles.push_back({a, a + 1, b});
                triangles.push_back({b, a + 1, b + 1});
            }
        of.world
            .create_body({.type = BodyType::static_body},
                         {.geometry = Mesh{build_mesh(vertices, triangles).value()},
                          .material = {.friction = 1}})
            .value();
        of.world.set_pose(of.chassis, {.position = {0, 1.67, 0}}).expect();
        VehicleDef def = plain_saloon(of.chassis);
        def.cast = cast;
        of.add(def);
        coast(of, 2);
        const double v = of.speed();
        double lowest = 9, highest = 0;
        for (int k = 0; k < 120; k++) {
            of.drive(step_time);
            lowest = std::min(lowest, of.body().center.y);
            highest = std::max(highest, of.body().center.y);
        }
        EXPECT_LT(highest - lowest, 2e-3);
        EXPECT_NEAR(of.speed(), v, 0.01);
    }
}

TEST(Ground, friction_is_read_from_the_ground) {
    TestCar of({}, {0, 0, -10});
    of.add(plain_saloon(of.chassis));
    coast(of, 0.5);
    // Turns the plane into ice by changing its material.
    for (const BodyId body : of.world.bodies())
        for (const ShapeId shape : of.world.shapes_of(body))
            if (body != of.chassis)
                // 0.2 combined with the tyre's 1
                of.world.set_material(shape, {.friction = 0.04}).expect();
    of.set({.brake = 1, .gear = 0});
    of.drive(1);
    const double v = of.speed();
    of.drive(1);
    EXPECT_NEAR(v - of.speed(), 0.2 * gravity, 0.02);
}

}  // namespace
}  // namespace jostle::test
