// SPDX-License-Identifier: MIT
//
// Torque distribution of an axle with one wheel on ice.
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

using modules::DifferentialLock;
using modules::DifferentialLockKind;

// Forces of the left and right rear wheels, the left one on ice, and their spin.
struct Split {
    double left, right, spin_left, spin_right;
    double spun_up;  // N, additional force that accelerates the spin of the wheel on ice
};
Split on_split_ground(std::optional<DifferentialLock> coupling) {
    TestCar of({.substeps = 2});
    VehicleDef def = plain_saloon(of.chassis);
    def.wheels[2].tyre.friction = 0.01;  // 0.1 combined with the ground's 1
    def.gearbox.automatic = false;       // prevents shifts
    if (coupling) def.differential_locks = {*coupling};
    of.add(def);
    of.drive(2);
    of.set({.throttle = 0.5});
    of.drive(1.0);
    const auto before = of.state().wheels;
    Split split{};
    constexpr int steps = 12;
    for (int k = 0; k < steps; k++) {
        of.drive(step_time);
        split.left += of.state().wheels[2].force.x / steps;
        split.right += of.state().wheels[3].force.x / steps;
    }
    const auto wheels = of.state().wheels;
    split.spin_left = wheels[2].spin;
    split.spin_right = wheels[3].spin;
    const double gained = wheels[2].spin - before[2].spin - (wheels[3].spin - before[3].spin);
    split.spun_up = 1.2 * gained / (steps * step_time) / 0.33;
    return split;
}

TEST(Differential, open_differential_is_limited_by_the_wheel_with_less_grip) {
    const Split split = on_split_ground({});
    RecordProperty("difference_off_N", std::to_string(split.right - split.left - split.spun_up));
    EXPECT_GT(split.spin_left, 2 * split.spin_right) << "the wheel on ice spins";
    EXPECT_NEAR(split.right - split.left, split.spun_up, 0.05 * split.right);
}

TEST(Differential, limited_slip_adds_its_friction_torque) {
    const DifferentialLock lock{.first = {2}, .second = {3}, .preload = 400, .ratio = 0};
    const Split split = on_split_ground(lock);
    EXPECT_GT(split.spin_left, 1.2 * split.spin_right);
    // Each side gets half of the torque; the friction torque of the lock reduces that of the faster
    // side and increases that of the slower one.
    const double expected = 2 * 400 / 0.33 + split.spun_up;
    RecordProperty("difference_off_percent",
                   std::to_string(100 * ((split.right - split.left) / expected - 1)));
    EXPECT_NEAR(split.right - split.left, expected, 0.05 * expected);
}

TEST(Differential, locked_differential_equalises_wheel_speeds) {
    const Split split = on_split_ground(
        DifferentialLock{.first = {2}, .second = {3}, .kind = DifferentialLockKind::locked});
    EXPECT_NEAR(split.spin_left, split.spin_right, 0.01 * split.spin_right);
    EXPECT_GT(split.right, 4 * split.left) << "only the wheel with grip drives";
}

TEST(Differential, locked_axle_resists_cornering_and_open_axle_does_not) {
    const auto difference = [](bool locked) {
        TestCar of({}, {0, 0, -5});
        VehicleDef def = plain_saloon(of.chassis);
        if (locked)
            def.differential_locks = {
                {.first = {2}, .second = {3}, .kind = DifferentialLockKind::locked}};
        of.add(def);
        coast(of, 0.5);
        of.set({.steering = 0.5, .gear = 0});
        of.drive(1.5);
        const auto wheels = of.state().wheels;
        return std::pair{wheels[2].spin - wheels[3].spin, -of.body().angular_velocity.y};
    };
    const auto [open, turn] = difference(false);
    // The outer wheel is 1.6 m farther out.
    EXPECT_NEAR(open, turn * 1.6 / 0.33, 0.02 * open);
    const auto [locked, less] = difference(true);
    EXPECT_NEAR(locked, 0, 0.01);
    EXPECT_LT(less, turn);
}

TEST(Differential, centre_lock_equalises_axle_speeds) {
    TestCar of;
    modules::SaloonDef saloon{.chassis = of.chassis};
    saloon.front_drive = 0.4;
    VehicleDef def = modules::saloon(saloon);
    for (std::size_t k : {0u, 1u}) def.wheels[k].tyre.friction = 0.01;
    def.differential_locks = {
        {.first = {0, 1}, .second = {2, 3}, .kind = DifferentialLockKind::locked}};
    of.add(def);
    of.set({.throttle = 0.6});
    of.drive(2);
    const auto wheels = of.state().wheels;
    const double front = wheels[0].spin + wheels[1].spin, rear = wheels[2].spin + wheels[3].spin;
    EXPECT_GT(rear, 5);
    EXPECT_NEAR(front, rear, 0.01 * rear);
}

}  // namespace
}  // namespace jostle::test
