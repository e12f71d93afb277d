// SPDX-License-Identifier: MIT
//
// Lanes come and go, and in time those of a colour lie in any order. Threads that share a colour
// take each its part of the lanes, and had to fetch bodies from each other's caches in every one.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

// Brings the contacts of large colour sets into the order of their bodies where many are out of it.
void sort_constraints(StepContext& step);

}  // namespace jostle::physics
