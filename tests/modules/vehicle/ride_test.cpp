// SPDX-License-Identifier: MIT
//
// Springs carry the load and oscillate at the configured frequency.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

using modules::AntiRollBar;
using modules::WheelCast;

TEST(Ride, car_at_rest_sags_by_weight_over_stiffness) {
    for (const WheelCast cast : {WheelCast::ray, WheelCast::sphere, WheelCast::cylinder}) {
        TestCar of;
        VehicleDef def = plain_saloon(of.chassis);
        def.cast = cast;
        of.add(def);
        of.drive(8);
        const CarState now = of.state();
        double worst = 0;
        for (const auto& wheel : now.wheels) {
            const double sag = car_mass * gravity / (4 * wheel.stiffness);
            worst = std::max(worst, std::abs(wheel.travel / sag - 1));
            EXPECT_NEAR(wheel.travel, sag, 0.001 * sag);
            EXPECT_NEAR(wheel.load, car_mass * gravity / 4, 1);
        }
        RecordProperty("sag_off_percent_" + std::to_string(static_cast<int>(cast)),
                       std::to_string(100 * worst));
    }
}

TEST(Ride, sag_does_not_depend_on_external_loads) {
    TestCar of;
    of.add(plain_saloon(of.chassis));
    of.world
        .create_body({.pose = {.position = {0, 1.3, 0}}},
                     {.geometry = Box{{0.4, 0.3, 0.4}}, .mass = 300})
        .value();
    of.drive(10);
    const double load = of.load({0, 1, 2, 3});
    RecordProperty("load_off_percent", std::to_string(100 * (load / (1800 * gravity) - 1)));
    EXPECT_NEAR(load, 1800 * gravity, 0.002 * 1800 * gravity);
    const auto wheel = of.state().wheels[0];
    EXPECT_NEAR(wheel.travel, 1800 * gravity / (4 * wheel.stiffness), 0.002 * wheel.travel);
}

// Measured from upward passes through the mean height.
double bounce_frequency(double frequency, int substeps) {
    TestCar of({.substeps = substeps});
    VehicleDef def = plain_saloon(of.chassis);
    for (auto& wheel : def.wheels) {
        wheel.suspension.frequency = frequency;
        wheel.suspension.damping = 0;
    }
    of.add(def);
    const double middle = 0.33 + 0.45 - gravity / std::pow(2 * pi * frequency, 2);
    of.world.set_pose(of.chassis, {.position = {0, middle + 0.01, 0}}).expect();
    double first = 0, last = 0, before = 0.01;
    int passes = 0;
    for (int k = 1; k <= 600; k++) {
        of.world.step(step_time).expect();
        const double above = of.body().center.y - middle;
        if (before < 0 && above >= 0) {
            last = (k - above / (above - before)) * step_time;
            if (passes++ == 0) first = last;
        }
        before = above;
    }
    return (passes - 1) / (last - first);
}

TEST(Ride, undamped_car_bounces_at_its_configured_frequency) {
    for (const double frequency : {1.0, 1.5, 2.5}) {
        const double found = bounce_frequency(frequency, 8);
        RecordProperty("off_percent_at_" + std::to_string(frequency),
                       std::to_string(100 * (found / frequency - 1)));
        EXPECT_NEAR(found, frequency, 0.01 * frequency);
    }
    EXPECT_NEAR(bounce_frequency(1.5, 1), 1.5, 0.015) << "one sub-step per step";
}

TEST(Ride, braking_load_transfer_matches_the_pitch_moment) {
    TestCar of({}, {0, 0, -30});
    VehicleDef def = plain_saloon(of.chassis);
    for (auto& wheel : def.wheels) {
        wheel.tyre.friction = 0.36;      // 0.6 combined with the ground's 1
        wheel.suspension.frequency = 4;  // stiff, because the formula assumes no pitch
        wheel.suspension.max_length = 0.36;
    }
    of.add(def);
    coast(of);
    of.set({.brake = 1, .gear = 0});
    of.drive(2);
    const double v = of.speed();
    double moved = 0, height = 0;
    for (int k = 0; k < 60; k++) {
        of.drive(step_time);
        moved += (of.load({0, 1}) - of.load({2, 3})) / 2 / 60;
        height += of.body().center.y / 60;
    }
    const double a = v - of.speed();
    const double expected = car_mass * a * height / 2.7;
    RecordProperty("load_transfer_off_percent", std::to_string(100 * (moved / expected - 1)));
    EXPECT_NEAR(a, 0.6 * gravity, 0.01 * 0.6 * gravity);
    EXPECT_NEAR(moved, expected, 0.01 * expected);
}

// The bar reduces roll according to its share of the stiffness.
TEST(Ride, anti_roll_bar_reduces_roll_by_its_stiffness) {
    const double share = roll_with_bars(plain_saloon, 8);
    RecordProperty("roll_share_off_percent", std::to_string(100 * (share - 1)));
    EXPECT_NEAR(share, 1, 0.01);
}

TEST(Ride, very_stiff_springs_stay_stable) {
    for (const double frequency : {5.0, 30.0, 100.0})
        for (const double damping : {0.0, 1.0, 10.0})
            for (const int substeps : {1, 8}) {
                TestCar of({.substeps = substeps});
                VehicleDef def = plain_saloon(of.chassis);
                for (auto& wheel : def.wheels) {
                    wheel.suspension.frequency = frequency;
                    wheel.suspension.damping = damping;
                }
                of.add(def);
                of.world.set_pose(of.chassis, {.position = {0, 1.2, 0}}).expect();
                of.drive(1);
                double highest = 0;
                for (int k = 0; k < 120; k++) {
                    of.drive(step_time);
                    highest = std::max(highest, std::abs(of.body().center.y - 0.78));
                }
                EXPECT_LT(highest, 0.5)
                    << frequency << " Hz, damping " << damping << ", " << substeps << " sub-steps";
                if (damping == 0) continue;  // does not come to rest
                EXPECT_NEAR(of.load({0, 1, 2, 3}), car_mass * gravity, 150)
                    << frequency << " Hz, damping " << damping << ", " << substeps << " sub-steps";
            }
}

TEST(Ride, car_stays_on_its_wheels_after_a_wall_crash) {
    TestCar of({}, {0, 0, -20});
    of.world
        .create_body({.type = BodyType::static_body, .pose = {.position = {0, 2, -12}}},
                     {.geometry = Box{{10, 2, 1}}})
        .value();
    of.add(plain_saloon(of.chassis));
    double highest = 0;
    for (int k = 0; k < 240; k++) {
        of.drive(step_time);
        highest = std::max(highest, of.body().center.y);
    }
    EXPECT_LT(highest, 1.2);
    EXPECT_GT(of.body().center.z, -9.05) << "it does not penetrate the wall";
    EXPECT_NEAR(of.load({0, 1, 2, 3}), car_mass * gravity, 0.02 * car_mass * gravity);
}

TEST(Ride, three_metre_fall_ends_on_the_wheels) {
    TestCar of;
    of.add(plain_saloon(of.chassis));
    of.world.set_pose(of.chassis, {.position = {0, 3.7, 0}}).expect();
    of.drive(5);
    EXPECT_NEAR(of.load({0, 1, 2, 3}), car_mass * gravity, 0.01 * car_mass * gravity);
    EXPECT_LT(of.speed(), 0.01);
}

}  // namespace
}  // namespace jostle::test
