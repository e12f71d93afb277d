// SPDX-License-Identifier: MIT
//
// Balance control of two-wheelers.
#pragma once

#include "jostle/physics/world.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

void measure_lean(const physics::BodyState& chassis, Car& car);

// Returns the steering, -1 to 1, positive to the right, that makes the lean follow the controls.
double balance_steering(const Car& car, double dt);

// Angular impulse of the feet for one solve, N m s, at low speed.
Vec3 feet_angular_impulse(const ChassisFrame& frame, const Car& car);

// Limits by the rider: brake torque in N m, and the fraction of the throttle. They do not affect
// cars.
double rider_brake(const Car& car, std::size_t wheel, double requested);
double rider_throttle(const Car& car);

}  // namespace jostle::modules::vehicle_detail
