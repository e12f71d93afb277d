// SPDX-License-Identifier: MIT
//
// Resting islands leave the awake set; of an island that does not rest as a whole, parts that do
// fall asleep in place (put_parts_to_sleep.h). An island that is in parts is split before, one in
// a step.
//
// Reads: times at rest (finalize_body), SolverScratch::jointed, contacts with kinematic bodies.
// Writes: islands, body sets, manifolds out of the constraint graph, sleep and end events; time at
// rest of what a moving kinematic body carries or tows becomes 0. Leaves nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped update_sleep(StepContext& step);

}  // namespace jostle::physics
