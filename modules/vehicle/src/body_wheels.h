// SPDX-License-Identifier: MIT
//
// Wheels that are bodies: made with their joints when the car is added, gone with it. The solver
// springs, steers and brakes them and finds what they touch; the drive line turns them. A wheel
// whose body or joint is gone is lost; the others drive on.
#pragma once

#include "jostle/physics/step_listener.h"
#include "jostle/physics/world.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

physics::Status make_body_wheels(physics::World& world, Car& car);
void destroy_body_wheels(physics::World& world, Car& car);
// Once a step, when rigs and controls are known.
void steer_and_brake(physics::World& world, Car& car);
void drive_body_wheels(physics::SubstepContext& substep, Car& car);
// What clients and state() are told.
void update_wheel_state(const physics::World& world, double dt, Car& car);

}  // namespace jostle::modules::vehicle_detail
