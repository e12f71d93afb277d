// SPDX-License-Identifier: MIT
//
// Moves a body's warm record between sets. Sets are contiguous: the last body fills the gap, and
// the constraint graph is updated.
#pragma once

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Adds `warm` to the set unchanged.
void enter_static(BodyStore& bodies, const BodyWarm& warm);
void enter_awake(BodyStore& bodies, const BodyWarm& warm);
// Removes a static or awake body from its set; a sleeping body leaves with its island.
void leave_set(ContactGraph& stores, std::uint32_t body);

}  // namespace jostle::physics
