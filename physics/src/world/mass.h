// SPDX-License-Identifier: MIT
//
// Mass, centre and inertia of a body from its shapes.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Recomputes what the body's shapes make of it and moves its centre of mass accordingly: the body's
// origin and the velocity of its material points stay. Its shapes' derived data follow.
void update_mass(WorldState& world, std::uint32_t body);

}  // namespace jostle::physics
