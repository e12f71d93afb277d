// SPDX-License-Identifier: MIT
//
// The parts of a car: how it is created, how it selects its controls, and what it does in each step
// and sub-step. Vehicles calls them.
#pragma once

#include <string>

#include "jostle/modules/vehicle_def.h"
#include "jostle/physics/module.h"
#include "jostle/physics/quat.h"
#include "jostle/physics/result.h"
#include "jostle/physics/state_visitor.h"
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

// Visits all saved state of a car.
void visit_car(physics::StateVisitor& v, Car& car);

// Validates definitions from callers and saved state. Both are untrusted.
//
// Return an empty string if valid, otherwise an error such as "wheels[2].radius is 0; it must be
// from 0.02 to 10".
std::string validate(const VehicleDef& def);
std::string validate(const CarControls& controls);
std::string validate(const Pilot& pilot);
std::string validate(const Car& car);

// Functions that parts of a car share.

// Impulse of drag and downforce at velocity v over the time h, N s; implicit in the drag.
inline physics::Vec3 aerodynamic_impulse(const Aerodynamics& air, physics::Vec3 v, physics::Vec3 up,
                                         double mass, double h) {
    const double speed = length(v), flow = 0.5 * air.density * speed * h;
    const double drag = flow * air.drag_area;
    const double press = physics::minimum(flow * speed * air.downforce_area, 100 * mass * h);
    return v * (-drag / (1 + drag / mass)) - up * press;
}

// The shortest rotation from one unit vector to another. For opposite vectors, half a turn about
// `otherwise`, which must be perpendicular to both.
inline physics::Quat rotation_between(physics::Vec3 from, physics::Vec3 to,
                                      physics::Vec3 otherwise) {
    const physics::Vec3 axis = cross(from, to);
    const physics::Quat q{axis.x, axis.y, axis.z, 1 + dot(from, to)};
    if (norm_squared(q) > 1e-12) return normalized(q);
    return {otherwise.x, otherwise.y, otherwise.z, 0};
}

}  // namespace jostle::modules::vehicle_detail
