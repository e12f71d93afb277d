// SPDX-License-Identifier: MIT
//
// Saved state of a car, and the validity of definitions and states.
#pragma once

#include <string>

#include "jostle/physics/result.h"
#include "jostle/physics/state_visitor.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

// Visits all saved state of a car.
void visit_car(physics::StateVisitor& v, Car& car);

// Validates definitions from callers and saved state. Both are untrusted.
//
// Return an empty string if valid, otherwise an error such as "wheels[2].radius is 0; it must be
// from 0.02 to 10".
std::string validate(const VehicleDef& def);
std::string validate(const CarControls& controls);
std::string validate(const Pilot& pilot);
std::string validate(const Car& car);

}  // namespace jostle::modules::vehicle_detail
