// SPDX-License-Identifier: MIT
//
// Engine, clutch and gearbox: the torque of the engine arrives at the road.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

// The speed at which the drive force equals air drag and rolling resistance: T(w) i n / R = rho / 2
// A v^2 + c m g.
double top_speed(const VehicleDef& def, double ratio) {
    double low = 1, high = 200;
    for (int k = 0; k < 60; k++) {
        const double v = 0.5 * (low + high), w = v / def.wheels[0].radius * ratio;
        const auto& curve = def.engine.curve;
        const double torque =
            curve[0].torque + (curve[1].torque - curve[0].torque) * w / curve[1].speed;
        const double push = torque * ratio * def.gearbox.efficiency / def.wheels[0].radius;
        const double held = 0.5 * def.aerodynamics.density * def.aerodynamics.drag_area * v * v +
                            def.wheels[0].tyre.rolling_resistance * car_mass * gravity;
        (push > held ? low : high) = v;
    }
    return low;
}

TEST(DriveLine, top_speed_balances_power_and_drag) {
    for (const double gear : {1.0, 0.7}) {
        TestCar of({}, {0, 0, -45});
        VehicleDef def = plain_saloon(of.chassis);
        def.engine.curve = {{0, 320}, {1000, 40}};
        def.engine.max_speed = 1000;
        def.gearbox = {.automatic = false, .forward = {gear}};
        def.aerodynamics = {.drag_area = 0.7};
        for (auto& wheel : def.wheels) wheel.tyre.rolling_resistance = 0.012;
        of.add(def);
        of.set({.throttle = 1, .gear = 1});
        of.drive(150);
        const double expected = top_speed(def, gear * def.gearbox.final_ratio);
        RecordProperty("top_speed_off_percent_gear_" + std::to_string(gear),
                       std::to_string(100 * (of.speed() / expected - 1)));
        EXPECT_NEAR(of.speed(), expected, 0.01 * expected);
    }
}

// a = T i n / R divided by the mass of the car and its rotating parts.
TEST(DriveLine, gear_ratio_multiplies_engine_torque) {
    for (const double gear : {1.0, 2.0}) {
        TestCar of({}, {0, 0, -15});
        VehicleDef def = plain_saloon(of.chassis);
        def.engine.curve = {{0, 200}};
        def.engine.max_speed = 5000;
        def.gearbox = {.automatic = false, .forward = {gear}, .efficiency = 1};
        of.add(def);
        of.set({.throttle = 1, .gear = 1});
        of.drive(1.5);
        const double v = of.speed();
        of.drive(1);
        const double i = gear * def.gearbox.final_ratio, r = 0.33;
        const double mass = car_mass + 4 * 1.2 / (r * r) + def.engine.inertia * i * i / (r * r);
        const double expected = 200 * i / r / mass, found = of.speed() - v;
        RecordProperty("acceleration_off_percent_gear_" + std::to_string(gear),
                       std::to_string(100 * (found / expected - 1)));
        EXPECT_NEAR(found, expected, 0.01 * expected);
    }
}

TEST(DriveLine, automatic_starts_and_shifts_up_to_top_gear) {
    TestCar of;
    of.add(plain_saloon(of.chassis));
    of.drive(1);
    EXPECT_LT(of.speed(), 0.01) << "the clutch is open at idle";
    of.set({.throttle = 1});
    std::int32_t gear = 1;
    double hundred = 0;
    for (int k = 0; k < 40 * 60; k++) {
        of.drive(step_time);
        const CarState now = of.state();
        EXPECT_GE(now.gear, gear) << "no downshift at full throttle, at " << k / 60.0 << " s";
        EXPECT_LE(now.engine_speed, 690);
        gear = now.gear;
        if (hundred == 0 && of.speed() > 100 / 3.6) hundred = (k + 1) / 60.0;
    }
    RecordProperty("seconds_to_100_km_h", std::to_string(hundred));
    EXPECT_EQ(gear, 5);
    EXPECT_GT(hundred, 5);
    EXPECT_LT(hundred, 15);

    of.set({.brake = 0.3});
    of.drive(20);
    EXPECT_EQ(of.state().gear, 1) << "shifts down while stopping";
    EXPECT_LT(of.speed(), 0.01);
    EXPECT_NEAR(of.state().engine_speed, 90, 5) << "the engine idles";
}

TEST(DriveLine, automatic_shifts_up_early_at_low_throttle_without_hunting) {
    TestCar of;
    VehicleDef def = plain_saloon(of.chassis);
    def.aerodynamics.drag_area = 3;  // so that it reaches a steady speed
    of.add(def);
    of.set({.throttle = 0.25});
    double fastest = 0;
    int shifts = 0;
    std::int32_t gear = 1;
    for (int k = 0; k < 60 * 60; k++) {
        of.drive(step_time);
        const CarState now = of.state();
        fastest = std::max(fastest, now.engine_speed);
        shifts += now.gear != gear ? 1 : 0;
        gear = now.gear;
    }
    EXPECT_LT(fastest, 0.9 * def.gearbox.shift_up_speed);
    EXPECT_GT(gear, 2);
    EXPECT_LE(shifts, 5);
}

TEST(DriveLine, reverse_engages_only_at_standstill) {
    TestCar of({}, {0, 0, -5});
    of.add(plain_saloon(of.chassis));
    coast(of, 0.5);
    of.set({.throttle = 0.3, .gear = -1});
    of.drive(0.5);
    EXPECT_EQ(of.state().gear, 0) << "not at 5 m/s forward";
    of.set({.brake = 1, .gear = -1});
    of.drive(2);
    of.set({.throttle = 0.3, .gear = -1});
    of.drive(3);
    EXPECT_EQ(of.state().gear, -1);
    EXPECT_LT(of.state().speed, -1);
}

TEST(DriveLine, manual_gearbox_follows_shift_commands) {
    TestCar of({}, {0, 0, -20});
    VehicleDef def = plain_saloon(of.chassis);
    def.gearbox.automatic = false;
    of.add(def);
    coast(of, 1);
    of.set({.gear = 2});
    of.drive(1);
    EXPECT_EQ(of.state().gear, 2);
    const double engine = of.state().engine_speed, wheel = of.state().wheels[2].spin;
    EXPECT_NEAR(engine, wheel * 2.1 * 3.7, 0.01 * engine) << "the clutch does not slip";
    EXPECT_LT(of.speed(), 20) << "engine braking";
    of.set({.clutch = 1, .gear = 2});
    of.drive(3);
    EXPECT_NEAR(of.state().engine_speed, 90, 10) << "idles with the clutch pedal down";
}

TEST(DriveLine, full_throttle_on_ice_spins_the_driven_wheels_only) {
    TestCar of;
    VehicleDef def = plain_saloon(of.chassis);
    for (auto& wheel : def.wheels) wheel.tyre.friction = 0.01;
    of.add(def);
    of.set({.throttle = 1});
    of.drive(3);
    const CarState now = of.state();
    EXPECT_GT(now.wheels[2].spin * 0.33, of.speed() + 5);
    EXPECT_NEAR(now.wheels[0].spin * 0.33, of.speed(), 0.05);
    // Half of the weight at a friction of 0.1, with small losses.
    EXPECT_NEAR(of.speed(), 0.5 * 0.1 * gravity * 3, 0.25);
}

TEST(DriveLine, airborne_wheel_spin_changes_transfer_angular_momentum_to_the_chassis) {
    TestCar of({.gravity = {}});
    VehicleDef def = plain_saloon(of.chassis);
    of.world.set_pose(of.chassis, {.position = {0, 50, 0}}).expect();
    of.add(def);
    of.set({.throttle = 1});
    of.drive(2);
    const CarState now = of.state();
    double spin = 0;
    for (const auto& wheel : now.wheels) spin += 1.2 * wheel.spin;
    EXPECT_GT(spin, 50);
    const BodyState body = of.body();
    // Forward rotation is about -x, so the chassis rotates about +x, with its nose up.
    EXPECT_NEAR((body.inertia * body.angular_velocity).x, spin, 0.001 * spin);
}

}  // namespace
}  // namespace jostle::test
