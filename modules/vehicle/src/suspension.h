// SPDX-License-Identifier: MIT
//
// What each wheel that touches bears: springs, dampers, stops and anti-roll bars of all wheels at
// once, implicitly, and nobody pulls at the ground.
#pragma once

#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

// Fills in Contact::load.
void solve_loads(const Car& car, const ChassisFrame& frame, Contacts& contacts);

}  // namespace jostle::modules::vehicle_detail
