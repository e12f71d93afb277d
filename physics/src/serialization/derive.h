// SPDX-License-Identifier: MIT
//
// Makes what is not saved from what is: after a load, before the first step.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// The world has passed check_state (state/validate.h).
void derive_all(WorldState& world);

}  // namespace jostle::physics
