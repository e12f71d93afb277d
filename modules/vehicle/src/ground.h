// SPDX-License-Identifier: MIT
//
// Finds the ground under each wheel once per step, at the predicted pose of the chassis in the
// middle of the step.
#pragma once

#include "jostle/physics/world.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

void find_wheel_ground(const physics::World& world, const physics::Queries& queries,
                       const physics::BodyState& chassis, double dt, Car& car);

}  // namespace jostle::modules::vehicle_detail
