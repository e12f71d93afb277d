// SPDX-License-Identifier: MIT
//
// Broad phase: which shapes may touch. Shapes that are new or left their fat box look for new
// neighbours, on many threads. What they find is sorted, so that contacts get the same indices
// whatever the threads and the kind of broad phase.
//
// Reads: ShapeStore::moved (filled by finalize in the step before, and by calls), fat boxes,
// filters, joints. Writes: a contact for each new pair, with a separation bound that is due; files
// a wake request for a pair nobody of which is awake; empties ShapeStore::moved. Leaves nothing in
// scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped update_pairs(StepContext& step);

}  // namespace jostle::physics
