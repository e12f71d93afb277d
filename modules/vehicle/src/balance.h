// SPDX-License-Identifier: MIT
//
// How a two-wheeler stays up.
#pragma once

#include "jostle/physics/world.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

void measure_lean(const physics::BodyState& chassis, Car& car);

// -1 to 1, right: what makes the lean follow the controls.
double balance_steering(const Car& car, double dt);

// N m s of a solve, where it is slow.
Vec3 feet_angular_impulse(const ChassisFrame& frame, const Car& car);

// What the rider makes of brakes, N m, and of the throttle: a share. Nothing of a car's.
double rider_brake(const Car& car, std::size_t wheel, double asked);
double rider_throttle(const Car& car);

}  // namespace jostle::modules::vehicle_detail
