// SPDX-License-Identifier: MIT
//
// Outlines of bodies in the plane of the walkers.
#pragma once

#include <vector>

#include "jostle/physics/world.h"
#include "modules/crowd/src/wall_tree.h"

namespace jostle::modules::crowd_detail {

// Returns the convex hulls of the shapes of a body, projected into the plane, as walls. Errors:
// not_found for an unknown body; invalid_argument if no shape is a box, a hull or round.
physics::Result<std::vector<Wall>> outline_of(const physics::World& world, physics::BodyId body,
                                              bool vertical);

}  // namespace jostle::modules::crowd_detail
