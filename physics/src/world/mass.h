// SPDX-License-Identifier: MIT
//
// Mass, centre of mass and inertia of a body from its shapes.
#pragma once

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Recomputes the mass properties of a body and moves its centre of mass accordingly. The body's
// origin and the velocity of its material points do not change. Also updates the derived data of
// its shapes.
void update_mass(ShapedBodies& stores, const WorldDef& def, std::uint32_t body);

}  // namespace jostle::physics
