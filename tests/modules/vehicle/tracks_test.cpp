// SPDX-License-Identifier: MIT
//
// Tracked vehicles: the wheels of a side turn together; the engine drives the sides against each
// other, or brakes hold one side.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

struct Tank : TestCar {
    explicit Tank(modules::TrackedDef of = {}) {
        of.chassis = chassis;
        of.wheel.suspension.frequency = 2;
        VehicleDef def = modules::tracked(of);
        def.gearbox.forward = {16, 8, 4};
        add(def);
        drive(1);
    }
};

TEST(Tracks, wheels_of_one_side_turn_together) {
    Tank of;
    of.set({.throttle = 0.5});
    of.drive(4);
    const auto wheels = of.state().wheels;
    ASSERT_EQ(wheels.size(), 10u);
    EXPECT_GT(wheels[0].spin, 5);
    for (std::size_t k = 1; k < 5; k++)
        EXPECT_NEAR(wheels[k].spin, wheels[0].spin, 1e-3 * wheels[0].spin);
    EXPECT_NEAR(of.body().center.x, 0, 0.01) << "it drives straight";
}

TEST(Tracks, braking_one_side_turns_the_vehicle_about_that_side) {
    Tank of({.steering_ratio = 0, .steering_brake = 4000});
    of.set({.throttle = 1, .steering = 1});
    of.drive(3);
    const BodyState body = of.body();
    const auto wheels = of.state().wheels;
    EXPECT_EQ(wheels[5].spin, 0) << "the right side is held";
    EXPECT_GT(wheels[0].spin, 1);
    EXPECT_LT(body.angular_velocity.y, -0.2) << "turns to the right";
    // The right track is dragged; the left one rolls.
    const Vec3 right = rotate(body.pose.rotation, {1, 0, 0});
    const Vec3 turn = cross(body.angular_velocity, right);
    EXPECT_LT(length(body.linear_velocity + turn), 0.5 * length(body.linear_velocity - turn));
}

// During a neutral turn at w rad/s on a rigid plane, every wheel slides: forward at u, equal on one
// side, and sideways at w z for a wheel z m in front of the middle. Coulomb friction opposes this
// with the same load everywhere. The moments about the middle balance, with the gauge b:
//     sum of (u b / 2 - w z^2) / sqrt(u^2 + w^2 z^2) = 0     (W. Steeds, "Tracked vehicles", 1950)
// Therefore s = u / w is a length that depends only on the vehicle, and w = R spin / (b / 2 + s).
// The steering drive sets spin = ratio * steering * engine speed.
double slide_of(const modules::TrackedDef& of) {
    double low = 0, high = of.length * of.length;
    for (int round = 0; round < 60; round++) {
        const double s = 0.5 * (low + high);
        double sum = 0;
        for (std::uint32_t k = 0; k < of.wheels; k++) {
            const double z = of.length * (static_cast<double>(k) / (of.wheels - 1) - 0.5);
            sum += (0.5 * s * of.gauge - z * z) / std::hypot(s, z);
        }
        (sum > 0 ? high : low) = s;
    }
    return 0.5 * (low + high);
}

struct Turning {
    double yaw = 0, engine = 0, moved = 0;  // rad/s to the right, rad/s, m
};
Turning turn_on_the_spot(Tank& of, const CarControls& controls) {
    of.set(controls);
    of.drive(4);
    const Vec3 start = of.body().center;
    Turning mean;
    for (int k = 0; k < 120; k++) {
        of.drive(step_time);
        mean.yaw -= of.body().angular_velocity.y / 120;
        mean.engine += of.state().engine_speed / 120;
    }
    mean.moved = length(of.body().center - start);
    return mean;
}

TEST(Tracks, neutral_turn_rate_matches_track_slip) {
    double worst = 0;
    for (const double length : {1.5, 2.5, 3.5})
        for (const double steering : {1.0, -1.0}) {
            const modules::TrackedDef def{.length = length};
            Tank of(def);
            const Turning turning = turn_on_the_spot(of, {.steering = steering});
            // At idle, the droop of the governor is a tenth.
            EXPECT_NEAR(turning.engine, 90, 9);
            const double spin = def.steering_ratio * steering * turning.engine;
            const double expected = 0.33 * spin / (0.5 * def.gauge + slide_of(def));
            worst = std::max(worst, std::abs(turning.yaw / expected - 1));
            EXPECT_LT(turning.moved, 0.02);
        }
    RecordProperty("worst_yaw_percent", std::to_string(100 * worst));
    EXPECT_LT(worst, 0.005);
}

// Tracks so short that they hardly slide: the yaw rate is the speed difference divided by the
// gauge.
TEST(Tracks, short_tracks_turn_by_their_speed_difference) {
    Tank of({.length = 0.2, .wheels = 2});
    const Turning turning = turn_on_the_spot(of, {.steering = 0.5, .gear = 0});
    const double expected = 2 * 0.33 * (0.03 * 0.5 * turning.engine) / 2;
    RecordProperty("yaw_percent", std::to_string(100 * (turning.yaw / expected - 1)));
    EXPECT_NEAR(turning.yaw, expected, 0.02 * expected);
}

TEST(Tracks, player_turns_on_the_spot_with_lateral_stick) {
    Tank of;
    of.vehicles->control(of.world, of.chassis, {.axes = {1, 0, 0, 0}});
    of.drive(4);
    EXPECT_LT(of.body().angular_velocity.y, -0.25);
    EXPECT_LT(of.speed(), 0.02);
}

// In gear, the engine speed drives both, so the radius depends only on the gear.
TEST(Tracks, turning_radius_in_gear_matches_the_steering_ratio) {
    const modules::TrackedDef def{.length = 0.2, .wheels = 2};
    Tank of(def);
    of.set({.throttle = 0.3, .steering = 0.1});
    of.drive(8);
    const CarState state = of.state();
    ASSERT_EQ(state.shifting, false);
    const double radius = state.speed / -of.body().angular_velocity.y;
    const double ratio = std::array<double, 3>{16, 8, 4}[static_cast<std::size_t>(state.gear) - 1];
    const double expected = 0.5 * def.gauge / (0.03 * 0.1 * ratio * 3.7);
    RecordProperty("radius_percent", std::to_string(100 * (radius / expected - 1)));
    EXPECT_NEAR(radius, expected, 0.02 * expected);
}

TEST(Tracks, supports_the_maximum_wheel_count) {
    Tank of({.wheels = 8});
    of.set({.throttle = 0.5});
    of.drive(3);
    EXPECT_EQ(of.state().wheels.size(), 16u);
    EXPECT_GT(of.speed(), 1);
}

}  // namespace
}  // namespace jostle::test
