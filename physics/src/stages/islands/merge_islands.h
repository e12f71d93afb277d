// SPDX-License-Identifier: MIT
//
// What hangs together: contacts that began to press bind islands, those that ended mark one that
// may be split, and both become events. After solve_constraints, because only then is it known
// which press; before the warm records change, because events tell the velocity of the approach.
//
// Reads: the flags that the last relaxing pass left in the constraint graph, warm records from
// before the solve, WorldState::changed_pairs. Writes: contacts, islands, begin, end and hit
// events; files wake requests for what sleeps in place and lost a touch. Leaves nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped merge_islands(StepContext& step);

}  // namespace jostle::physics
