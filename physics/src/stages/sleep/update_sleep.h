// SPDX-License-Identifier: MIT
//
// Moves resting islands out of the awake set. Resting parts of other islands fall asleep in place
// (put_parts_to_sleep.h). An island of several parts is split first, one per step.
//
// Reads: rest times (finalize_body), SolverScratch::jointed, contacts with kinematic bodies.
// Writes: islands, body sets, manifolds removed from the constraint graph, sleep and end events;
// resets the rest time of bodies that a moving kinematic body carries or tows. Leaves nothing in
// scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped update_sleep(StepContext& step);

}  // namespace jostle::physics
