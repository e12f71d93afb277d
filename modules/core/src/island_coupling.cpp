// SPDX-License-Identifier: MIT
#include "jostle/modules/island_coupling.h"

namespace jostle::modules {

using namespace physics;

Result<JointId> create_island_coupling(World& world, BodyId a, BodyId b) {
    // A constraint row whose impulse is limited to zero.
    return world.create_joint({.body_a = a,
                               .body_b = b,
                               .kind = VelocityRow{.lower = 0, .upper = 0},
                               .collide_connected = true});
}

}  // namespace jostle::modules
