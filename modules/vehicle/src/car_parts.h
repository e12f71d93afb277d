// SPDX-License-Identifier: MIT
//
// The parts of a car: how it is created, how it selects its controls, and what it does in each step
// and sub-step. Vehicles calls them.
#pragma once

#include "jostle/physics/module.h"
#include "jostle/physics/step_listener.h"
#include "jostle/physics/world.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

// Creates a car from a definition: normalizes axes and derives springs from the load on the wheels.
Car make_car(const VehicleDef& def, const physics::BodyState& chassis, Vec3 gravity);

// Sources of controls: a pilot that follows a circle, and driver input.

CarControls pilot_controls(const Car& car, const physics::BodyState& chassis);

// Controls from driver input: forward is throttle, backward is brake, and reverse once the car
// stands.
CarControls driver_controls(const Car& car);

// Stores driver input. A press of a gear button shifts a manual gearbox once.
void apply_driver_input(Car& car, const physics::Controls& controls);

// Finds the ground under each wheel once per step, at the predicted pose of the chassis in the
// middle of the step.
void find_wheel_ground(const physics::World& world, const physics::Queries& queries,
                       const physics::BodyState& chassis, double dt, Car& car);

// Gear selection, once per step.
void choose_gear(Car& car, double dt);

// Balance control of two-wheelers.

void measure_lean(const physics::BodyState& chassis, Car& car);

// Returns the steering, -1 to 1, positive to the right, that makes the lean follow the controls.
double balance_steering(const Car& car, double dt);

// Angular impulse of the feet for one solve, N m s, at low speed.
Vec3 feet_angular_impulse(const ChassisFrame& frame, const Car& car);

// Limits by the rider: brake torque in N m, and the fraction of the throttle. They do not affect
// cars.
double rider_brake(const Car& car, std::size_t wheel, double requested);
double rider_throttle(const Car& car);

// Wheels that are bodies: created with their joints when the car is added, and destroyed with it.
// The solver provides suspension, steering, brakes and contacts; the drive line drives them. If a
// body or a joint of a wheel is destroyed, the wheel is lost and the others continue.
physics::Status make_body_wheels(physics::World& world, Car& car);
void destroy_body_wheels(physics::World& world, Car& car);
// Once per step, after the wheel axes and controls are known.
void steer_and_brake(physics::World& world, Car& car);
void drive_body_wheels(physics::SubstepContext& substep, Car& car);
// Updates the wheel state for clients and state().
void update_wheel_state(const physics::World& world, double dt, Car& car);

// Solves the loads of all wheels in contact at once and implicitly: springs, dampers, bump stops
// and anti-roll bars. Loads are never negative.

// Computes Contact::load.
void solve_loads(const Car& car, const ChassisFrame& frame, Contacts& contacts);

// One sub-step of a car: finds contacts, solves suspension loads, drive line and tyre forces, and
// applies the resulting impulse.
void step_car(physics::SubstepContext& substep, Car& car);

}  // namespace jostle::modules::vehicle_detail
