// SPDX-License-Identifier: MIT
//
// Recomputes derived data after a load, before the first step.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Precondition: the world has passed find_fault (state/validate.h).
void derive_all(WorldState& world);

}  // namespace jostle::physics
