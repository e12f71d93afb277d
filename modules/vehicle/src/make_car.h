// SPDX-License-Identifier: MIT
//
// Creates a car from a definition: normalizes axes and derives springs from the load on the wheels.
#pragma once

#include "jostle/physics/world.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

Car make_car(const VehicleDef& def, const physics::BodyState& chassis, Vec3 gravity);

}  // namespace jostle::modules::vehicle_detail
