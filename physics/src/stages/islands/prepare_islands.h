// SPDX-License-Identifier: MIT
//
// Chooses the solver effort for each island from the island alone. A world therefore behaves
// independently of its other content and of the speed of the machine.
//
// A contact is a spring whose stiffness is proportional to the square of the sub-step rate. A wall
// of n layers stands while the tilt stiffness of its contacts exceeds the overturning moment, which
// is proportional to the cube of n (Greenhill, "Height consistent with stability", 1881). A heavy
// body on a light one loads a spring dimensioned for the light one. Both need more sub-steps.
//
// An island that lost a load starts with its impulses reduced accordingly. Otherwise these
// impulses, which warm-start the next step, would throw it upwards.
//
// Reads: awake bodies, touching contacts, joints, Island::remaining_load. Writes: tier and batch of
// islands (Island::colour_set), and with them the colours and slots of contacts; impulses of
// islands that lost a load. Runs every eighth step and after a load was lost; with a tolerance, in
// every step (choose_substep_levels.h). Leaves nothing else in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped prepare_islands(StepContext& step);

}  // namespace jostle::physics
