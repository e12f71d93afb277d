// SPDX-License-Identifier: MIT
//
// How hard the solver works on an island follows from the island alone, so a world behaves the same
// whatever else is in it and however fast the machine is.
//
// A contact is a spring whose stiffness grows with the square of the sub-step rate. A wall of n
// layers stands while the stiffness of its contacts against tilt exceeds the moment of what leans,
// which grows with the cube of n (Greenhill, "Height consistent with stability", 1881). A heavy
// body on a light one presses a spring made for the light one. Both take more sub-steps.
//
// What bore something that is gone starts with as much less: its impulses, which warm-start the
// next step, would throw it up.
//
// Reads: awake bodies, contacts that press, joints, Island::remaining_load. Writes: tier and batch
// of islands (Island::colour_set), and with them the colours and slots of contacts; impulses of
// islands that lost a load. Runs every eighth step, and when a load was lost; with a tolerance,
// every step (choose_substep_levels.h). Leaves nothing else in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped prepare_islands(StepContext& step);

}  // namespace jostle::physics
