// SPDX-License-Identifier: MIT
//
// One sub-step of one car: where its wheels touch, what they bear, how the drive line turns them,
// how tyres answer, and the push that comes of it.
#pragma once

#include "jostle/physics/step_listener.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

void step_car(physics::SubstepContext& substep, Car& car);

}  // namespace jostle::modules::vehicle_detail
