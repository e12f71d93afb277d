// SPDX-License-Identifier: MIT
//
// Lanes come and go, and in time those of a colour lie in any order. Then each thread that shares
// the colours would fetch bodies from the caches of the others in each of them.
//
// Reads and writes: the slots of contacts in the constraint graph. Part of prepare_islands.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Brings the contacts of large colour sets into the order of their bodies where many are out of it.
void sort_constraints(StepContext& step);

}  // namespace jostle::physics
