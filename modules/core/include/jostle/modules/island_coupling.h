// SPDX-License-Identifier: MIT
//
// Couples bodies between which a module transmits forces within sub-steps, such as a winch and its
// load. Coupled bodies belong to one island, and therefore to one group of SubstepContext. They
// sleep and wake together. The coupling applies no force, and the shapes of the bodies still
// collide.
#pragma once

#include "jostle/physics/world.h"

namespace jostle::modules {

/// Couples two bodies, of which at least one must be dynamic. The coupling is a joint: it ends with
/// World::destroy_joint() or when one of the bodies is destroyed. Errors are those of
/// World::create_joint().
physics::Result<physics::JointId> create_island_coupling(physics::World& world, physics::BodyId a,
                                                         physics::BodyId b);
/// Returns whether a joint couples islands only.
bool is_island_coupling(const physics::JointKind& kind);

}  // namespace jostle::modules
