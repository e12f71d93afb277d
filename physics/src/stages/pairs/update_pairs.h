// SPDX-License-Identifier: MIT
//
// Broad phase: which shapes may touch. Shapes that left their fat box look for new neighbours.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped update_pairs(StepContext& step);

}  // namespace jostle::physics
