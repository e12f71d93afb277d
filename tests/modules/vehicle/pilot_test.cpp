// SPDX-License-Identifier: MIT
//
// Driver input: sticks and buttons.
#include <gtest/gtest.h>

#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

struct ControlledCar : TestCar {
    explicit ControlledCar(bool automatic = true) {
        VehicleDef def = plain_saloon(chassis);
        def.gearbox.automatic = automatic;
        add(def);
        drive(1);
    }
    void hold(double right, double forward, std::uint32_t buttons = 0) {
        Controls controls;
        controls.axes[0] = right;
        controls.axes[1] = forward;
        controls.buttons = buttons;
        vehicles->control(world, chassis, controls);
    }
};

TEST(PlayerDriver, drives_forward_brakes_and_then_reverses) {
    ControlledCar of;
    ASSERT_TRUE(of.vehicles->is_controllable(of.chassis));
    EXPECT_FALSE(of.vehicles->is_controllable(of.world.bodies()[0]));
    of.hold(0, 1);
    of.drive(3);
    const double fast = of.state().speed;
    EXPECT_GT(fast, 5);
    of.hold(0, -1);
    of.drive(0.5);
    EXPECT_EQ(of.state().controls.brake, 1);
    EXPECT_LT(of.state().speed, fast);
    of.drive(4);
    EXPECT_LT(of.state().speed, -1) << "reverses after standstill";
    of.hold(0, 1);
    of.drive(4);
    EXPECT_GT(of.state().speed, 1) << "drives forward again";
}

TEST(PlayerDriver, steers_right_and_applies_the_hand_brake) {
    ControlledCar of;
    of.hold(0.5, 0.5);
    of.drive(2);
    EXPECT_LT(of.body().angular_velocity.y, -0.1);
    of.hold(0, 0, 1);
    of.drive(4);
    EXPECT_EQ(of.state().wheels[2].spin, 0);
    EXPECT_LT(of.speed(), 0.1);
}

TEST(PlayerDriver, shifts_once_per_button_press) {
    ControlledCar of(false);
    of.hold(0, 0.5, 4);
    of.hold(0, 0.5, 4);
    EXPECT_EQ(of.state().controls.gear, 2) << "a held button does not shift again";
    of.hold(0, 0.5, 0);
    of.hold(0, 0.5, 4);
    EXPECT_EQ(of.state().controls.gear, 3);
    for (int k = 0; k < 9; k++) of.hold(0, 0.5, k % 2 == 0 ? 8 : 0);
    EXPECT_EQ(of.state().controls.gear, -1) << "reverse is the lowest gear";
}

}  // namespace
}  // namespace jostle::test
