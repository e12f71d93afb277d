// SPDX-License-Identifier: MIT
//
// Sorted, ready to read.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped publish_events(StepContext& step);

}  // namespace jostle::physics
