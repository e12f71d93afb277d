// SPDX-License-Identifier: MIT
//
// Bodies of many shapes. A world takes a body's mass anew after each shape that it is created with:
// so they begin with one, and get all of them at once.
#pragma once

#include <vector>

#include "jostle/physics/world.h"

namespace jostle::modules::destruction_detail {

// All or none, in their order.
physics::Result<std::vector<physics::BodyId>> make_bodies(
    physics::World& world, std::vector<physics::BodyAndShapes> bodies);

}  // namespace jostle::modules::destruction_detail
