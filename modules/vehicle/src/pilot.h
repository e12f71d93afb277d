// SPDX-License-Identifier: MIT
//
<<<<<<< HEAD
// Drivers: one that keeps to a circle (Pilot), and one that holds sticks.
=======
// Who drives: a pilot that keeps to a circle, or a person with sticks and buttons.
>>>>>>> vehicle
#pragma once

#include "car.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules::vehicle_detail {

CarControls pilot_controls(const Car& car, const physics::BodyState& chassis);
// What the sticks mean now: back is the brake while it goes ahead, and reverse after. The faster it
// goes the less a full stick steers.
CarControls stick_controls(const Car& car);

// Of what is held: ahead is throttle, back is the brake, and reverse once the car stands.
CarControls person_controls(const Car& car);

// Takes hold, once: a press of a gear button shifts a manual gearbox.
void hold_controls(Car& car, const physics::Controls& controls);

}  // namespace jostle::modules::vehicle_detail
