// SPDX-License-Identifier: MIT
//
// The whole step, read top to bottom.
#pragma once

#include "state/world_state.h"

namespace jostle::physics {

void step_world(WorldState& world, double dt);

}  // namespace jostle::physics
