// SPDX-License-Identifier: MIT
//
// Wheels that are bodies: created with their joints when the car is added, and destroyed with it.
// The solver provides suspension, steering, brakes and contacts; the drive line drives them. If a
// body or a joint of a wheel is destroyed, the wheel is lost and the others continue.
#pragma once

#include "jostle/physics/step_listener.h"
#include "jostle/physics/world.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

physics::Status make_body_wheels(physics::World& world, Car& car);
void destroy_body_wheels(physics::World& world, Car& car);
// Once per step, after the wheel axes and controls are known.
void steer_and_brake(physics::World& world, Car& car);
void drive_body_wheels(physics::SubstepContext& substep, Car& car);
// Updates the wheel state for clients and state().
void update_wheel_state(const physics::World& world, double dt, Car& car);

}  // namespace jostle::modules::vehicle_detail
