// SPDX-License-Identifier: MIT
//
// Where each wheel meets the ground: once a step, where the chassis will be in its middle.
#pragma once

#include "jostle/physics/world.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

void find_wheel_ground(const physics::World& world, const physics::Queries& queries,
                       const physics::BodyState& chassis, double dt, Car& car);

}  // namespace jostle::modules::vehicle_detail
