// SPDX-License-Identifier: MIT
//
// Moves a body's warm record from set to set. Sets are contiguous: the last body moves into the
// hole, and the constraint graph is told.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// `warm` is taken as it is.
void enter_static(WorldState& world, const BodyWarm& warm);
void enter_awake(WorldState& world, const BodyWarm& warm);
// Static or awake ones; a sleeping body leaves with its island.
void leave_set(WorldState& world, std::uint32_t body);

}  // namespace jostle::physics
