// SPDX-License-Identifier: MIT
//
// A motorcycle stays up by steering, and leans into a bend as far as the bend asks for.
#include <cmath>

#include <gtest/gtest.h>

#include "test_car.h"

namespace jostle::test {
namespace {

struct Motorcycle : TestCar {
    explicit Motorcycle(double speed) : TestCar({}, {0, 0, -speed}) {
        world.destroy_body(chassis).expect();
        chassis = world
                      .create_body(
                          {.pose = {.position = {0, 0.65, 0}}, .linear_velocity = {0, 0, -speed}},
                          {.geometry = Box{{0.12, 0.25, 0.5}}, .mass = 250})
                      .value();
        modules::MotorcycleDef of{.chassis = chassis};
        of.wheel.radius = 0.3;
        of.wheel.width = 0.14;
        of.wheel.inertia = 0.6;
        of.wheel.tyre.rolling_resistance = 0;
        VehicleDef def = modules::motorcycle(of);
        def.aerodynamics.drag_area = 0;
        add(def);
    }
    double lean() const {
        return arc_tangent(-rotate(body().pose.rotation, {1, 0, 0}).y,
                           rotate(body().pose.rotation, {0, 1, 0}).y);
    }
};

TEST(Balance, it_rides_straight_and_rights_itself_after_a_push) {
    Motorcycle of(12);
    of.set({.gear = 0});
    of.drive(3);
    EXPECT_LT(std::abs(of.lean()), 0.01);
    of.world.apply_angular_impulse(of.chassis, {0, 0, 25}).expect();
    double furthest = 0;
    for (int k = 0; k < 60; k++) {
        of.drive(step_time);
        furthest = std::max(furthest, std::abs(of.lean()));
    }
    EXPECT_GT(furthest, 0.01) << "the push was felt";
    of.drive(4);
    EXPECT_LT(std::abs(of.lean()), 0.01);
}

TEST(Balance, it_leans_into_a_bend_by_the_bends_own_angle) {
    for (const double steering : {-0.6, 0.3, 0.8}) {
        Motorcycle of(15);
        of.set({.steering = steering, .gear = 0});
        of.drive(5);
        const double lean = of.lean();
        EXPECT_NEAR(lean, steering * 0.7, 0.07);
        const double aside = -of.body().angular_velocity.y * of.speed();
        // A round tread of 0.07 m touches to the side: the centre of mass leans over that.
        const double height = of.body().center.y;
        const double expected = gravity * std::tan(lean) * (height - 0.07) / height;
        RecordProperty("bend_off_percent_at_" + std::to_string(steering),
                       std::to_string(100 * (aside / expected - 1)));
        EXPECT_NEAR(aside, expected, 0.02 * std::abs(expected));
    }
}

TEST(Balance, to_turn_right_it_first_steers_left) {
    Motorcycle of(15);
    of.set({.gear = 0});
    of.drive(2);
    of.set({.steering = 0.5, .gear = 0});
    of.drive(0.1);
    EXPECT_LT(of.state().wheels[0].steering, 0);
    of.drive(2);
    EXPECT_GT(of.state().wheels[0].steering, 0);
}

TEST(Balance, feet_hold_it_where_it_stands) {
    Motorcycle of(0);
    of.set({.brake = 1, .gear = 0});
    of.drive(10);
    EXPECT_LT(std::abs(of.lean()), 0.02);
    of.set({.throttle = 0.5});
    of.drive(6);
    EXPECT_GT(of.speed(), 8);
    EXPECT_LT(std::abs(of.lean()), 0.05) << "and it sets off upright";
}

}  // namespace
}  // namespace jostle::test
