// SPDX-License-Identifier: MIT
//
// The whole step, read top to bottom.
#pragma once

#include "stages/step_scratch.h"
#include "state/world_state.h"

namespace jostle::physics {

void step_world(WorldState& world, StepScratch& scratch, double dt);

}  // namespace jostle::physics
