// SPDX-License-Identifier: MIT
//
// Drivers: one that keeps to a circle (Pilot), and one that holds sticks.
#pragma once

#include "car.h"
#include "jostle/physics/world.h"

namespace jostle::modules::vehicle_detail {

CarControls pilot_controls(const Car& car, const physics::BodyState& chassis);
// What the sticks mean now: back is the brake while it goes ahead, and reverse after. The faster it
// goes the less a full stick steers.
CarControls stick_controls(const Car& car);

}  // namespace jostle::modules::vehicle_detail
