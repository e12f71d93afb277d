// SPDX-License-Identifier: MIT
//
// A driver that keeps to a circle: Pilot.
#pragma once

#include "car.h"
#include "jostle/physics/world.h"

namespace jostle::modules::vehicle_detail {

CarControls pilot_controls(const Car& car, const physics::BodyState& chassis);

}  // namespace jostle::modules::vehicle_detail
