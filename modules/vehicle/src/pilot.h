// SPDX-License-Identifier: MIT
//
// Sources of controls: a pilot that follows a circle, and driver input.
#pragma once

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

CarControls pilot_controls(const Car& car, const physics::BodyState& chassis);

// Controls from driver input: forward is throttle, backward is brake, and reverse once the car
// stands.
CarControls driver_controls(const Car& car);

// Stores driver input. A press of a gear button shifts a manual gearbox once.
void apply_driver_input(Car& car, const physics::Controls& controls);

}  // namespace jostle::modules::vehicle_detail
