// SPDX-License-Identifier: MIT
//
// Visits all saved state of a car.
#pragma once

#include "jostle/physics/state_visitor.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

void visit_car(physics::StateVisitor& v, Car& car);

}  // namespace jostle::modules::vehicle_detail
