// SPDX-License-Identifier: MIT
//
// Tracks: the wheels of a side turn as one, and braking a side turns the vehicle.
#include <cmath>

#include <gtest/gtest.h>

#include "test_car.h"

namespace jostle::test {
namespace {

struct Tank : TestCar {
    explicit Tank(std::uint32_t wheels = 5) {
        modules::TrackedDef of{.chassis = chassis, .wheels = wheels};
        of.wheel.suspension.frequency = 2;
        VehicleDef def = modules::tracked(of);
        def.gearbox.ahead = {16, 8, 4};
        add(def);
        drive(1);
    }
};

TEST(Tracks, all_wheels_of_a_side_turn_as_one) {
    Tank of;
    of.set({.throttle = 0.5});
    of.drive(4);
    const auto wheels = of.state().wheels;
    ASSERT_EQ(wheels.size(), 10u);
    EXPECT_GT(wheels[0].spin, 5);
    for (std::size_t k = 1; k < 5; k++)
        EXPECT_NEAR(wheels[k].spin, wheels[0].spin, 1e-3 * wheels[0].spin);
    EXPECT_NEAR(of.body().center.x, 0, 0.01) << "and it drives straight";
}

TEST(Tracks, a_braked_side_turns_it_about_itself) {
    Tank of;
    of.set({.throttle = 1, .steering = 1});
    of.drive(3);
    const BodyState body = of.body();
    const auto wheels = of.state().wheels;
    EXPECT_EQ(wheels[5].spin, 0) << "the right side stands";
    EXPECT_GT(wheels[0].spin, 1);
    EXPECT_LT(body.angular_velocity.y, -0.2) << "it turns to the right";
    // The right track is dragged, the left one rolls.
    const Vec3 right = rotate(body.pose.rotation, {1, 0, 0});
    const Vec3 turn = cross(body.angular_velocity, right);
    EXPECT_LT(length(body.linear_velocity + turn), 0.5 * length(body.linear_velocity - turn));
}

TEST(Tracks, the_most_wheels_that_there_may_be) {
    Tank of(8);
    of.set({.throttle = 0.5});
    of.drive(3);
    EXPECT_EQ(of.state().wheels.size(), 16u);
    EXPECT_GT(of.speed(), 1);
}

}  // namespace
}  // namespace jostle::test
