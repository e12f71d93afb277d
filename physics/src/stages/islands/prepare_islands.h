// SPDX-License-Identifier: MIT
//
// What an island is decides how hard the solver works on it: from the island alone, so a world
// behaves the same whatever else is in it and however fast the machine is.
//
// A contact is a spring whose stiffness grows with the square of the sub-step rate. A wall of n
// layers stands while the stiffness of its joints against tilt exceeds the moment of what leans,
// which grows with the cube of n (Greenhill, "Height consistent with stability", 1881); a heavy
// body on a light one presses a spring made for the light one. Both take more sub-steps.
//
// What bore something that is gone starts with as much less: its impulses, which warm-start the
// next step, would throw it up.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped prepare_islands(StepContext& step);

}  // namespace jostle::physics
