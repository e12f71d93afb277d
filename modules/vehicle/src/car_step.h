// SPDX-License-Identifier: MIT
//
// One sub-step of a car: finds contacts, solves suspension loads, drive line and tyre forces, and
// applies the resulting impulse.
#pragma once

#include "jostle/physics/step_listener.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

void step_car(physics::SubstepContext& substep, Car& car);

}  // namespace jostle::modules::vehicle_detail
