// SPDX-License-Identifier: MIT
//
// Validates definitions from callers and saved state. Both are untrusted.
#pragma once

#include <string>

#include "jostle/physics/result.h"
#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

// Return an empty string if valid, otherwise an error such as "wheels[2].radius is 0; it must be
// from 0.02 to 10".
std::string validate(const VehicleDef& def);
std::string validate(const CarControls& controls);
std::string validate(const Pilot& pilot);
std::string validate(const Car& car);

}  // namespace jostle::modules::vehicle_detail
