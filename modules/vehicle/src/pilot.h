// SPDX-License-Identifier: MIT
//
// Who drives: a pilot that keeps to a circle, or a person with sticks and buttons.
#pragma once

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

CarControls pilot_controls(const Car& car, const physics::BodyState& chassis);

// Of what is held: ahead is throttle, back is the brake, and reverse once the car stands.
CarControls driver_controls(const Car& car);

// Takes hold, once: a press of a gear button shifts a manual gearbox.
void apply_driver_input(Car& car, const physics::Controls& controls);

}  // namespace jostle::modules::vehicle_detail
