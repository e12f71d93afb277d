// SPDX-License-Identifier: MIT
//
// Tyre forces are limited by friction, and cars respond to steering as in the bicycle model.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

using modules::Wheel;

TEST(Grip, locked_wheels_stop_within_v_squared_over_2_mu_g) {
    for (const double v : {10.0, 20.0, 30.0})
        for (const double mu : {0.4, 1.0}) {
            TestCar of({}, {0, 0, -v});
            VehicleDef def = plain_saloon(of.chassis);
            for (auto& wheel : def.wheels) wheel.tyre.friction = mu * mu;
            of.add(def);
            coast(of);
            const double v0 = of.speed(), from = of.body().center.z;
            of.set({.brake = 1, .gear = 0});
            // The last step before standstill is excluded, because treads then spring back a
            // little.
            double distance = 0, speed = v0;
            while (speed > 0.2) {
                of.drive(step_time);
                speed = -of.body().linear_velocity.z;
            }
            distance = from - of.body().center.z + speed * speed / (2 * mu * gravity);
            const double expected = v0 * v0 / (2 * mu * gravity);
            of.drive(3);
            EXPECT_LT(of.speed(), 1e-3);
            EXPECT_NEAR(from - of.body().center.z, expected, 0.005 * expected + 0.03);
            RecordProperty("off_percent_at_" + std::to_string(static_cast<int>(v)) + "_mu_" +
                               std::to_string(mu),
                           std::to_string(100 * (distance / expected - 1)));
            EXPECT_NEAR(distance, expected, 0.005 * expected) << v << " m/s, friction " << mu;
        }
}

// Acceleration perpendicular to the velocity, averaged over 1 s at 20 m/s.
double lateral_acceleration(TestCar& of) {
    const Vec3 initial = of.body().linear_velocity;
    double turned = 0, speed = 0;
    Vec3 last = initial;
    for (int k = 0; k < 60; k++) {
        const Vec3 v = of.body().linear_velocity;
        const double lost = 20 - length(v);
        of.world.apply_impulse(of.chassis, v / length(v) * (car_mass * lost), of.body().center)
            .expect();
        of.drive(step_time);
        const Vec3 now = of.body().linear_velocity;
        turned += arc_tangent(cross(last, now).y, dot(last, now));
        speed += length(now) / 60;
        last = now;
    }
    return std::abs(turned) * speed;
}

// The car is towed at its centre of mass, so its tyres only provide lateral force.
TEST(Grip, skid_pad_lateral_acceleration_reaches_mu_g) {
    for (const double mu : {0.5, 0.9}) {
        TestCar of({}, {0, 0, -20});
        VehicleDef def = plain_saloon(of.chassis);
        for (std::size_t k = 0; k < 4; k++) {
            Wheel& wheel = def.wheels[k];
            wheel.tyre.friction = mu * mu;
            // Understeers, so that the front slides first.
            wheel.tyre.cornering_stiffness = k < 2 ? 30 : 40;
            wheel.suspension.frequency = 2.5;
        }
        of.add(def);
        coast(of, 1);
        double most = 0;
        for (double steering = 0.1; steering <= 0.6; steering += 0.05) {
            of.set({.steering = steering, .gear = 0});
            most = std::max(most, lateral_acceleration(of));
        }
        RecordProperty("skid_pad_off_percent_mu_" + std::to_string(mu),
                       std::to_string(100 * (most / (mu * gravity) - 1)));
        EXPECT_NEAR(most, mu * gravity, 0.03 * mu * gravity);
    }
}

// r / delta = V / (L + K V^2), K = (1 / c_front - 1 / c_rear) / g if stiffness is proportional to
// load.
TEST(Grip, yaw_response_matches_the_bicycle_model) {
    struct Case {
        double front, rear;
    };
    for (const Case c : {Case{12, 20}, Case{15, 15}, Case{16, 14}})
        for (const double v : {8.0, 20.0, 35.0}) {
            TestCar of({}, {0, 0, -v});
            VehicleDef def = plain_saloon(of.chassis);
            for (std::size_t k = 0; k < 4; k++) {
                def.wheels[k].tyre.cornering_stiffness = k < 2 ? c.front : c.rear;
                def.wheels[k].suspension.damping = 1;
            }
            of.add(def);
            coast(of, 1);
            of.set({.steering = 0.0005 / 0.6, .gear = 0});
            of.drive(6);
            const double speed = of.speed();
            const double gain = -of.body().angular_velocity.y / 0.0005;
            const double k = (1 / c.front - 1 / c.rear) / gravity;
            const double expected = speed / (2.7 + k * speed * speed);
            RecordProperty("yaw_gain_off_percent_" + std::to_string(static_cast<int>(c.front)) +
                               "_" + std::to_string(static_cast<int>(v)),
                           std::to_string(100 * (gain / expected - 1)));
            EXPECT_NEAR(gain, expected, 0.02 * expected) << c.front << ", " << c.rear << ", " << v;
        }
}

TEST(Grip, parked_car_does_not_creep) {
    for (const double slope : {10.0, 25.0, 38.0})  // degrees; friction holds up to 45
        for (const bool sideways : {false, true}) {
            const double along = gravity * std::sin(slope * pi / 180),
                         down = gravity * std::cos(slope * pi / 180);
            TestCar of({.gravity = sideways ? Vec3{along, -down, 0} : Vec3{0, -down, along}});
            VehicleDef def = plain_saloon(of.chassis);
            for (auto& wheel : def.wheels) wheel.hand_brake_torque = 5000;
            of.add(def);
            of.set({.hand_brake = 1, .gear = 0});
            of.drive(10);
            const Vec3 from = of.body().center;
            of.drive(60);
            const double crept = length(of.body().center - from);
            RecordProperty(
                "creep_mm_" + std::to_string(static_cast<int>(slope)) + (sideways ? "_aside" : ""),
                std::to_string(1e3 * crept));
            EXPECT_LT(crept, 0.001) << slope << " degrees";
        }
}

TEST(Grip, parked_car_slides_above_the_friction_angle_per_coulomb) {
    const double along = 8, down = 6;
    TestCar of({.gravity = {0, -down, along}});
    VehicleDef def = plain_saloon(of.chassis);
    for (auto& wheel : def.wheels) wheel.hand_brake_torque = 8000;
    of.add(def);
    of.set({.hand_brake = 1, .gear = 0});
    of.drive(2);
    const double v = of.speed();
    of.drive(2);
    EXPECT_NEAR((of.speed() - v) / 2, along - down, 0.02);
}

// Braking and cornering share one friction circle.
TEST(Grip, braking_reduces_cornering_force) {
    TestCar of({}, {0, 0, -20});
    of.add(plain_saloon(of.chassis));
    coast(of, 1);
    of.set({.brake = 1, .steering = 0.5, .gear = 0});
    of.drive(1);
    const auto wheels = of.state().wheels;
    for (const auto& wheel : wheels) {
        EXPECT_LE(std::hypot(wheel.force.x, wheel.force.y), 1.0001 * wheel.load);
        EXPECT_GT(std::hypot(wheel.force.x, wheel.force.y), 0.99 * wheel.load)
            << "the wheel slides";
    }
    EXPECT_LT(std::abs(of.body().angular_velocity.y), 0.15) << "locked wheels do not steer";
}

TEST(Grip, hand_brake_causes_oversteer) {
    TestCar of({}, {0, 0, -15});
    of.add(plain_saloon(of.chassis));
    coast(of, 1);
    of.set({.hand_brake = 1, .steering = 0.5, .gear = 0});
    of.drive(1.5);
    const BodyState body = of.body();
    const Vec3 forward = rotate(body.pose.rotation, {0, 0, -1});
    const double drift = arc_tangent(length(cross(forward, body.linear_velocity)),
                                     dot(forward, body.linear_velocity));
    RecordProperty("drift_degrees", std::to_string(drift * 180 / pi));
    EXPECT_GT(drift, 0.4);
}

}  // namespace
}  // namespace jostle::test
