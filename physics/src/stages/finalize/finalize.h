// SPDX-License-Identifier: MIT
//
// Hot results back to the double records; travel, rest time and bounds of every awake body.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped finalize(StepContext& step);

}  // namespace jostle::physics
