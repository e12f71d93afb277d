// SPDX-License-Identifier: MIT
//
// Solves the loads of all wheels in contact at once and implicitly: springs, dampers, bump stops
// and anti-roll bars. Loads are never negative.
#pragma once

#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

// Computes Contact::load.
void solve_loads(const Car& car, const ChassisFrame& frame, Contacts& contacts);

}  // namespace jostle::modules::vehicle_detail
