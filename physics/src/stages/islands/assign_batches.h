// SPDX-License-Identifier: MIT
//
// Deals the islands of a tier out among batches, so that threads find equal work. Islands go whole,
// with all that manifolds tie to them, and only when the batches have become unequal. It follows
// from the world alone, so that every number of threads steps it alike.
//
// Reads: awake bodies, how many contacts and joints they have. Writes: Island::colour_set, and with
// it the colours of contacts. Part of prepare_islands.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

void assign_batches(StepContext& step);

}  // namespace jostle::physics
