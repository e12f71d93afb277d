// SPDX-License-Identifier: MIT
//
// Updates islands: contacts that began to touch merge islands, contacts that ended mark an island
// that may be split, and both become events. Runs after solve_constraints, because only then the
// touching contacts are known, and before the warm records change, because events report the
// approach velocity.
//
// Reads: the flags of the last relaxing pass in the constraint graph, warm records before the
// solve, WorldState::changed_pairs. Writes: contacts, islands, begin, end and hit events; files
// wake requests for bodies that sleep in place and lost a contact. Leaves nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped merge_islands(StepContext& step);

}  // namespace jostle::physics
