// SPDX-License-Identifier: MIT
//
// The walk over all of a car that is saved.
#pragma once

#include "jostle/physics/state_visitor.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

void visit_car(physics::StateVisitor& v, Car& car);

}  // namespace jostle::modules::vehicle_detail
