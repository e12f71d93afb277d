// SPDX-License-Identifier: MIT
//
// Which of the pairs that do not touch are worth a look in this step.
#pragma once

#include "state/world_state.h"

namespace jostle::physics {

// Whether a pair may touch in this step; if not, knows from when on to ask again.
bool is_due(const WorldState& world, SeparationBound& w, double dt);

}  // namespace jostle::physics
