// SPDX-License-Identifier: MIT
//
// A saloon of 1,500 kg on flat ground, for vehicle tests. Rolling resistance and air drag are
// disabled by default.
#pragma once

#include <memory>
#include <utility>

#include "jostle/modules/vehicle.h"
#include "jostle/physics/physics.h"

namespace jostle::test {

using namespace physics;
using modules::CarControls;
using modules::CarId;
using modules::CarState;
using modules::SaloonDef;
using modules::VehicleDef;
using modules::Vehicles;

inline constexpr double car_mass = 1500, gravity = 9.81, step_time = 1.0 / 60;

inline BodyId add_chassis(World& world, Vec3 position, Vec3 velocity = {}) {
    return world
        .create_body({.pose = {.position = position}, .linear_velocity = velocity},
                     {.geometry = Box{{0.8, 0.25, 2}}, .mass = car_mass})
        .value();
}

inline VehicleDef plain_saloon(BodyId chassis) {
    SaloonDef of{.chassis = chassis};
    of.wheel.tyre.rolling_resistance = 0;
    of.wheel.brake_torque = 8000;
    of.anti_roll = 0;
    VehicleDef def = modules::saloon(of);
    def.aerodynamics = {.drag_area = 0};
    def.differential_locks.clear();
    return def;
}

inline WorldDef sleepless(WorldDef def) {
    def.sleeping = false;
    return def;
}

struct TestCar {
    World world;
    Vehicles* vehicles = nullptr;
    BodyId chassis;
    CarId car = 0;

    explicit TestCar(const WorldDef& of = {}, Vec3 velocity = {}) : world(sleepless(of)) {
        world
            .create_body({.type = BodyType::static_body},
                         {.geometry = Plane{}, .material = {.friction = 1}})
            .value();
        chassis = add_chassis(world, {0, 0.67, 0}, velocity);
        auto made = std::make_unique<Vehicles>();
        vehicles = made.get();
        world.add_module(std::move(made)).expect();
    }

    void add(const VehicleDef& def) { car = vehicles->add(world, def).value(); }
    void set(const CarControls& controls) { vehicles->set_controls(world, car, controls).expect(); }
    void drive(double seconds) {
        for (int k = 0; k < static_cast<int>(seconds * 60 + 0.5); k++)
            world.step(step_time).expect();
    }
    CarState state() const { return vehicles->state(car).value(); }
    BodyState body() const { return world.body(chassis).value(); }
    double speed() const { return length(body().linear_velocity); }
    double load(std::initializer_list<std::size_t> wheels) const {
        const CarState now = state();
        double sum = 0;
        for (const std::size_t wheel : wheels) sum += now.wheels[wheel].load;
        return sum;
    }
};

// Lets the wheels reach the speed of the chassis in neutral.
inline void coast(TestCar& of, double seconds = 2) {
    of.set({.gear = 0});
    of.drive(seconds);
}

// Measured roll reduction by anti-roll bars, divided by the expected one; 1 is correct. Tilted
// gravity replaces a bend at a steady roll angle.
inline double roll_with_bars(VehicleDef (*make)(BodyId), double seconds) {
    constexpr double bar = 20'000;
    const auto roll = [&](double stiffness) {
        TestCar of({.gravity = {3, -gravity, 0}});
        VehicleDef def = make(of.chassis);
        def.anti_roll_bars = {{0, 1, stiffness}, {2, 3, stiffness}};
        of.add(def);
        of.set({.hand_brake = 1, .gear = 0});
        of.drive(seconds);
        const auto wheels = of.state().wheels;
        return std::pair{wheels[1].travel - wheels[0].travel, wheels[0].stiffness};
    };
    const auto [free, k] = roll(0);
    const auto [barred, same] = roll(bar);
    // The roll stiffness is k t^2, with bars (k + 2 bar) t^2, minus the effect of the chassis
    // leaning over its wheels: m g times the length of the suspension.
    const double t2 = 1.6 * 1.6, lean = car_mass * gravity * 0.34;
    return barred / free / ((k * t2 - lean) / ((k + 2 * bar) * t2 - lean));
}

}  // namespace jostle::test
