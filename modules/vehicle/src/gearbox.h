// SPDX-License-Identifier: MIT
//
// Gear selection, once per step.
#pragma once

#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

void choose_gear(Car& car, double dt);

}  // namespace jostle::modules::vehicle_detail
