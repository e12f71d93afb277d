// SPDX-License-Identifier: MIT
//
// A motorcycle balances by steering, and leans into a bend by the equilibrium angle.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

struct Motorcycle : TestCar {
    explicit Motorcycle(double speed, double drag = 0) : TestCar({}, {0, 0, -speed}) {
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
        def.aerodynamics.drag_area = drag;
        add(def);
    }
    double lean() const {
        return arc_tangent(-rotate(body().pose.rotation, {1, 0, 0}).y,
                           rotate(body().pose.rotation, {0, 1, 0}).y);
    }
};

TEST(Balance, rides_straight_and_recovers_after_a_push) {
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
    EXPECT_GT(furthest, 0.01) << "the push has an effect";
    of.drive(4);
    EXPECT_LT(std::abs(of.lean()), 0.01);
}

// The equilibrium angle of the line from the contact to the centre of mass: atan(v^2 / (g r)).
TEST(Balance, leans_into_a_turn_by_the_equilibrium_angle) {
    double worst = 0;
    for (const double speed : {6.0, 8.0, 15.0, 25.0, 40.0, 60.0})
        for (const double steering : {-0.9, -0.6, 0.3, 0.8}) {
            Motorcycle of(speed);
            of.set({.steering = steering, .gear = 0});
            of.drive(5);
            const BodyState body = of.body();
            const double lateral = -body.angular_velocity.y * of.speed();
            const auto wheels = of.state().wheels;
            const Vec3 arm = body.center - (wheels[0].point + wheels[1].point) * 0.5;
            const Vec3 right = normalized(cross(body.linear_velocity, Vec3{0, 1, 0}));
            const double lean = std::atan2(dot(arm, right), arm.y);
            worst = std::max(worst, std::abs(lean / std::atan(lateral / gravity) - 1));
            EXPECT_GT(lean * steering, 0);
            // At most the requested lean, and not much less.
            EXPECT_LT(std::abs(lean), 0.7 * std::abs(steering) + 0.04);
            EXPECT_GT(std::abs(lean), (speed < 8 ? 0.3 : 0.85) * 0.7 * std::abs(steering));
        }
    RecordProperty("lean_off_percent", std::to_string(100 * worst));
    EXPECT_LT(worst, 0.02);
}

TEST(Balance, stays_upright_after_a_push_at_any_speed) {
    double furthest = 0, left = 0;
    for (const double speed : {0.0, 0.5, 1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0, 40.0, 60.0, 70.0}) {
        Motorcycle of(speed);
        of.set({.gear = 0});
        of.drive(3);
        of.world.apply_angular_impulse(of.chassis, {0, 0, 25}).expect();
        for (int k = 0; k < 300; k++) {
            of.drive(step_time);
            furthest = std::max(furthest, std::abs(of.lean()));
        }
        left = std::max(left, std::abs(of.lean()));
    }
    RecordProperty("furthest_rad", std::to_string(furthest));
    RecordProperty("left_rad", std::to_string(left));
    EXPECT_LT(furthest, 0.1);
    EXPECT_LT(left, 0.01);
}

TEST(Balance, stays_upright_on_both_wheels_from_standstill_to_top_speed) {
    Motorcycle of(0, 0.4);
    of.set({.throttle = 1});
    double lean = 0, pitch = 0, before = 0;
    for (int k = 0; k < 60 * 60; k++) {
        of.drive(step_time);
        lean = std::max(lean, std::abs(of.lean()));
        pitch = std::max(pitch, std::abs(rotate(of.body().pose.rotation, {0, 0, 1}).y));
        if (k == 60 * 50) before = of.speed();
    }
    RecordProperty("top_speed", std::to_string(of.speed()));
    EXPECT_GT(of.speed(), 55);
    EXPECT_NEAR(of.speed(), before, 0.01);
    EXPECT_LT(lean, 0.001);
    EXPECT_LT(pitch, 0.2) << "no more than the springs allow";
}

TEST(Balance, full_braking_neither_pitches_over_nor_falls_in_a_turn) {
    for (const double speed : {5.0, 10.0, 20.0, 40.0})
        for (const double steering : {0.0, 0.4}) {
            Motorcycle of(speed);
            of.set({.steering = steering, .gear = 0});
            of.drive(4);
            const double v = of.speed();
            of.set({.brake = 1, .steering = steering, .gear = 0});
            double lean = 0, pitch = 0, stopped = 0;
            for (int k = 0; k < 600; k++) {
                of.drive(step_time);
                lean = std::max(lean, std::abs(of.lean()));
                pitch = std::max(pitch, std::abs(rotate(of.body().pose.rotation, {0, 0, 1}).y));
                if (of.speed() > 0.1) stopped = k * step_time;
            }
            EXPECT_LT(lean, 0.7 * steering + 0.2);
            EXPECT_LT(pitch, 0.2);
            EXPECT_LT(of.speed(), 1e-3);
            EXPECT_LT(std::abs(of.lean()), 0.01);
            EXPECT_LT(stopped, v / (0.55 * gravity) + 1) << "it brakes with about 2/3 g";
        }
}

TEST(Balance, parked_motorcycle_stands_for_a_minute_and_survives_a_push) {
    Motorcycle of(0);
    of.set({.brake = 1, .gear = 0});
    of.drive(60);
    EXPECT_LT(std::abs(of.lean()), 1e-3);
    EXPECT_LT(of.speed(), 1e-6);
    of.world.apply_angular_impulse(of.chassis, {0, 0, 50}).expect();
    of.drive(5);
    EXPECT_LT(std::abs(of.lean()), 0.01);
}

// Feet do not lift a fallen motorcycle and have no effect in the air.
TEST(Balance, knocked_over_motorcycle_stays_down) {
    for (const double speed : {0.0, 2.0, 10.0}) {
        Motorcycle of(speed);
        of.set({.gear = 0});
        of.drive(1);
        of.world.apply_angular_impulse(of.chassis, {0, 0, 900}).expect();
        double fastest = 0;
        for (int k = 0; k < 1200; k++) {
            of.drive(step_time);
            fastest = std::max(fastest, of.speed());
        }
        EXPECT_GT(std::abs(of.lean()), 1) << "it lies on its side";
        EXPECT_LT(of.speed(), 0.1);
        EXPECT_LT(fastest, speed + 8);
    }
}

TEST(Balance, countersteers_left_to_turn_right) {
    Motorcycle of(15);
    of.set({.gear = 0});
    of.drive(2);
    of.set({.steering = 0.5, .gear = 0});
    of.drive(0.1);
    EXPECT_LT(of.state().wheels[0].steering, 0);
    of.drive(2);
    EXPECT_GT(of.state().wheels[0].steering, 0);
}

TEST(Balance, feet_keep_it_upright_at_standstill) {
    Motorcycle of(0);
    of.set({.brake = 1, .gear = 0});
    of.drive(10);
    EXPECT_LT(std::abs(of.lean()), 0.02);
    of.set({.throttle = 0.5});
    of.drive(6);
    EXPECT_GT(of.speed(), 8);
    EXPECT_LT(std::abs(of.lean()), 0.05) << "it starts upright";
}

}  // namespace
}  // namespace jostle::test
