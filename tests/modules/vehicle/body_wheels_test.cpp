// SPDX-License-Identifier: MIT
//
// Wheels that are bodies on wheel joints of the solver pass the tests of ray and shape cast wheels,
// with Coulomb friction instead of a tyre model.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

VehicleDef with_bodies(BodyId chassis) {
    VehicleDef def = plain_saloon(chassis);
    def.cast = modules::WheelCast::body;
    return def;
}

constexpr double wheel_mass = 20, total_mass = car_mass + 4 * wheel_mass;

TEST(BodyWheels, car_at_rest_sags_by_weight_over_stiffness) {
    double worst = 0;
    for (const double frequency : {1.0, 1.5, 3.0}) {
        TestCar of;
        VehicleDef def = with_bodies(of.chassis);
        for (auto& wheel : def.wheels) wheel.suspension.frequency = frequency;
        of.add(def);
        of.drive(15);
        for (const auto& wheel : of.state().wheels) {
            const double expected = car_mass * gravity / (4 * wheel.stiffness);
            worst = std::max(worst, std::abs(wheel.travel / expected - 1));
            EXPECT_TRUE(wheel.touches);
            EXPECT_NEAR(wheel.load, total_mass * gravity / 4, 0.001 * total_mass * gravity);
        }
    }
    RecordProperty("sag_off_percent", std::to_string(100 * worst));
    EXPECT_LT(worst, 0.001);
}

TEST(BodyWheels, preload_is_carried_before_the_spring_compresses) {
    TestCar of;
    VehicleDef def = with_bodies(of.chassis);
    for (auto& wheel : def.wheels) wheel.suspension.preload = 2000;
    of.add(def);
    of.drive(15);
    const auto wheel = of.state().wheels[0];
    const double expected = (car_mass * gravity / 4 - 2000) / wheel.stiffness;
    EXPECT_NEAR(wheel.travel, expected, 0.001 * expected);
}

TEST(BodyWheels, locked_wheels_stop_within_v_squared_over_2_mu_g) {
    double worst = 0;
    for (const double speed : {10.0, 20.0, 30.0}) {
        TestCar of({}, {0, 0, -speed});
        of.add(with_bodies(of.chassis));
        coast(of, 2);
        const double v = of.speed();
        const Vec3 start = of.body().center;
        of.set({.brake = 1, .gear = 0});
        // Afterwards it rocks back on its locked wheels.
        double furthest = 0;
        for (int k = 0; k < static_cast<int>(60 * (v / gravity + 3)); k++) {
            of.drive(step_time);
            furthest = std::max(furthest, start.z - of.body().center.z);
        }
        EXPECT_LT(of.speed(), 1e-3);
        const double expected = v * v / (2 * gravity);
        worst = std::max(worst, std::abs(furthest / expected - 1));
    }
    RecordProperty("stop_off_percent", std::to_string(100 * worst));
    EXPECT_LT(worst, 0.005);
}

// In first gear, the engine would brake the rear wheels with more than the friction of the ground,
// and a car with sliding rear wheels spins around. The gearbox must therefore select a suitable
// gear immediately.
TEST(BodyWheels, car_released_at_60_m_s_in_gear_goes_straight) {
    for (const int substeps : {1, 8}) {
        WorldDef def;
        def.substeps = substeps;
        TestCar of(def, {0, 0, -60});
        of.add(with_bodies(of.chassis));
        of.set({.throttle = 0.5});
        const int steps = 480 / substeps;  // 480 sub-steps per second
        for (int k = 0; k < 4 * steps; k++) of.world.step(1.0 / steps).expect();
        EXPECT_GT(of.speed(), 50);
        EXPECT_EQ(of.state().gear, 5);
        // After about 220 m.
        const double sideways = std::abs(of.body().center.x);
        EXPECT_LT(sideways, 0.5);
        RecordProperty("sideways_m_by_" + std::to_string(substeps), std::to_string(sideways));
    }
}

TEST(BodyWheels, top_speed_balances_power_and_drag) {
    TestCar of({}, {0, 0, -30});
    VehicleDef def = with_bodies(of.chassis);
    def.engine.curve = {{0, 200}};
    def.engine.max_speed = 1000;
    def.gearbox = {.automatic = false, .forward = {1}};
    def.aerodynamics = {.drag_area = 2.5};
    of.add(def);
    of.set({.throttle = 1, .gear = 1});
    of.drive(120);
    // T i n / R = rho / 2 A v^2
    const double push = 200 * 3.7 * 0.95 / 0.33;
    const double expected = std::sqrt(push / (0.5 * 1.2 * 2.5));
    RecordProperty("top_speed_off_percent", std::to_string(100 * (of.speed() / expected - 1)));
    EXPECT_NEAR(of.speed(), expected, 0.01 * expected);
}

// a = T i / R divided by the mass of the car and its rotating parts.
TEST(BodyWheels, engine_accelerates_the_total_mass) {
    TestCar of({}, {0, 0, -15});
    VehicleDef def = with_bodies(of.chassis);
    def.engine.curve = {{0, 200}};
    def.engine.max_speed = 5000;
    def.gearbox = {.automatic = false, .forward = {2}, .efficiency = 1};
    of.add(def);
    of.set({.throttle = 1, .gear = 1});
    of.drive(3);
    const double before = of.speed();
    of.drive(2);
    const double ratio = 2 * 3.7, r2 = 0.33 * 0.33;
    const double spins = 4 * 0.5 * wheel_mass + 0.2 * ratio * ratio / r2;
    const double expected = 200 * ratio / 0.33 / (total_mass + spins);
    const double a = (of.speed() - before) / 2;
    RecordProperty("acceleration_off_percent", std::to_string(100 * (a / expected - 1)));
    EXPECT_NEAR(a, expected, 0.01 * expected);
}

TEST(BodyWheels, parked_car_does_not_creep_on_a_slope) {
    TestCar of({.gravity = {0, -gravity * std::cos(0.4), gravity * std::sin(0.4)}});
    of.add(with_bodies(of.chassis));
    of.set({.brake = 1, .gear = 0});
    of.drive(5);
    const Vec3 start = of.body().center;
    of.drive(60);
    RecordProperty("creep_mm", std::to_string(1000 * length(of.body().center - start)));
    EXPECT_LT(length(of.body().center - start), 1e-3);
}

TEST(BodyWheels, anti_roll_bar_reduces_roll_by_its_stiffness) {
    const double share = roll_with_bars(with_bodies, 10);
    RecordProperty("roll_share_off_percent", std::to_string(100 * (share - 1)));
    EXPECT_NEAR(share, 1, 0.03);
}

// Engine and brakes are internal: they do not change the total angular momentum.
TEST(BodyWheels, airborne_car_conserves_momentum) {
    TestCar of({.gravity = {}});
    of.world.set_pose(of.chassis, {.position = {0, 50, 0}}).expect();
    of.add(with_bodies(of.chassis));
    of.set({.throttle = 1});
    of.drive(1);
    of.set({.brake = 1, .steering = 1});
    of.drive(1);
    const WorldSummary summary = of.world.summary();
    EXPECT_LT(length(summary.linear_momentum), 1e-4);
    EXPECT_LT(length(summary.angular_momentum), 1);
    of.set({.throttle = 1, .clutch = 0});
    of.drive(1);
    EXPECT_GT(of.state().wheels[2].spin, 10);
}

TEST(BodyWheels, full_throttle_on_ice_spins_the_driven_wheels_only) {
    TestCar of;
    VehicleDef def = with_bodies(of.chassis);
    for (auto& wheel : def.wheels) wheel.tyre.friction = 0.02;
    of.add(def);
    of.drive(1);
    of.set({.throttle = 1});
    of.drive(3);
    const CarState state = of.state();
    EXPECT_GT(state.wheels[2].spin * 0.33, 5 * of.speed());
    EXPECT_NEAR(state.wheels[0].spin * 0.33, state.speed, 0.2 + 0.1 * state.speed);
    // mu g of the driven half of the weight, with some load transfer.
    EXPECT_LT(of.speed(), 0.14 * gravity * 3);
}

TEST(BodyWheels, climbs_a_kerb_of_half_its_wheel_radius) {
    TestCar of({}, {0, 0, -4});
    of.world
        .create_body({.type = BodyType::static_body, .pose = {.position = {0, 0, -55}}},
                     {.geometry = Box{{5, 0.16, 50}}, .material = {.friction = 1}})
        .value();
    of.add(with_bodies(of.chassis));
    of.set({.throttle = 0.5});
    of.drive(4);
    EXPECT_GT(of.body().center.y, 0.7);
    EXPECT_LT(of.body().center.z, -6);
}

TEST(BodyWheels, car_drives_on_without_a_destroyed_wheel) {
    TestCar of;
    of.add(with_bodies(of.chassis));
    of.drive(1);
    const std::size_t bodies = of.world.bodies().size();
    ASSERT_EQ(bodies, 6u) << "ground, chassis and four wheels";
    const BodyId wheel = of.world.joint(of.world.joints_of(of.chassis)[0])->def.body_b;
    of.world.destroy_body(wheel).expect();
    of.set({.throttle = 0.5});
    of.drive(4);
    EXPECT_GT(of.speed(), 3);
    EXPECT_FALSE(of.state().wheels[0].touches);
    EXPECT_EQ(of.state().wheels[0].load, 0);
}

TEST(BodyWheels, wheels_are_removed_with_the_car_and_its_chassis) {
    TestCar of;
    of.add(with_bodies(of.chassis));
    of.drive(0.5);
    of.vehicles->remove(of.world, of.car).expect();
    EXPECT_EQ(of.world.bodies().size(), 2u);
    of.add(with_bodies(of.chassis));
    EXPECT_EQ(of.world.bodies().size(), 6u);
    of.world.destroy_body(of.chassis).expect();
    of.drive(step_time);
    EXPECT_EQ(of.world.bodies().size(), 1u);
}

TEST(BodyWheels, parked_car_sleeps_and_controls_wake_it) {
    TestCar of;
    of.world = World();
    of.world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).value();
    of.chassis = add_chassis(of.world, {0, 0.67, 0});
    auto made = std::make_unique<Vehicles>();
    of.vehicles = made.get();
    of.world.add_module(std::move(made)).expect();
    of.add(with_bodies(of.chassis));
    of.set({.brake = 1, .gear = 0});
    of.drive(6);
    EXPECT_FALSE(of.body().awake);
    of.set({.throttle = 1});
    of.drive(2);
    EXPECT_GT(of.speed(), 3);
}

TEST(BodyWheels, rejects_body_wheels_on_two_wheelers) {
    TestCar of;
    VehicleDef def = modules::motorcycle({.chassis = of.chassis});
    def.cast = modules::WheelCast::body;
    const auto car = of.vehicles->add(of.world, def);
    ASSERT_FALSE(car.ok());
    EXPECT_NE(car.error().message.find("balance.enabled"), std::string::npos);
}

}  // namespace
}  // namespace jostle::test
