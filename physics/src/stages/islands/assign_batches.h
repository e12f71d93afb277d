// SPDX-License-Identifier: MIT
//
// Deals the islands of an tier out among batches, so that threads find equal work: whole, with
// all that manifolds tie to them, and never more often than the batches have become unequal. From
// the world alone, so that every number of threads steps it alike.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

void assign_batches(StepContext& step);

}  // namespace jostle::physics
