// SPDX-License-Identifier: MIT
//
// Restores the order of lanes. As contacts begin and end, the lanes of a colour lose their order.
// Each thread that shares the colours would then load bodies from the caches of other threads.
//
// Reads and writes: the slots of contacts in the constraint graph. Part of prepare_islands.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Sorts the contacts of large colour sets by their bodies if many are out of order.
void sort_constraints(StepContext& step);

}  // namespace jostle::physics
