// SPDX-License-Identifier: MIT
//
// A car as it is added: its axes are unit, its springs fit what rests on them.
#pragma once

#include "jostle/physics/world.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

Car make_car(const VehicleDef& def, const physics::BodyState& chassis, Vec3 gravity);

}  // namespace jostle::modules::vehicle_detail
