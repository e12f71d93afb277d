// SPDX-License-Identifier: MIT
//
// Broad phase: finds shapes that may touch. Shapes that are new or left their fat box are queried
// for new neighbours, on several threads. The results are sorted, so that contacts get the same
// indices for any number of threads and any broad phase.
//
// Reads: ShapeStore::moved (written by finalize in the previous step and by API calls), fat boxes,
// filters, joints. Writes: a contact for each new pair, with a separation bound that is due; files
// a wake request for a pair without awake bodies; clears ShapeStore::moved. Leaves nothing in
// scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped update_pairs(StepContext& step);

}  // namespace jostle::physics
