// SPDX-License-Identifier: MIT
#include "jostle/modules/island_coupling.h"

#include <variant>

namespace jostle::modules {

using namespace physics;

Result<JointId> create_island_coupling(World& world, BodyId a, BodyId b) {
    // A constraint row whose impulse is limited to zero.
    return world.create_joint({.body_a = a,
                               .body_b = b,
                               .kind = VelocityRow{.lower = 0, .upper = 0},
                               .collide_connected = true});
}

bool is_island_coupling(const JointKind& kind) {
    const auto* row = std::get_if<VelocityRow>(&kind);
    return row != nullptr && row->lower == 0 && row->upper == 0;
}

}  // namespace jostle::modules
