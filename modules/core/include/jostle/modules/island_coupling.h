// SPDX-License-Identifier: MIT
//
// Binds bodies that a module lets push each other within sub-steps, such as a winch and its load:
// they are then in one island, so in one group of SubstepContext, and sleep and wake together. It
// pushes nothing, and lets their shapes collide.
#pragma once

#include "jostle/physics/world.h"

namespace jostle::modules {

// At least one of them is dynamic. Ends with World::destroy_joint(), or with a body.
physics::Result<physics::JointId> create_island_coupling(physics::World& world, physics::BodyId a,
                                                         physics::BodyId b);

}  // namespace jostle::modules
