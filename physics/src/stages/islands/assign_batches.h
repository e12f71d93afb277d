// SPDX-License-Identifier: MIT
//
// Distributes the islands of a tier over batches so that threads get equal work. Islands are moved
// whole, with all islands coupled to them by manifolds, and only when the batches have become
// unequal. The result depends only on the world, so it is the same for any number of threads.
//
// Reads: awake bodies with their numbers of contacts and joints. Writes: Island::colour_set, and
// with it the colours of contacts. Part of prepare_islands.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

void assign_batches(StepContext& step);

}  // namespace jostle::physics
