// SPDX-License-Identifier: MIT
//
// What is inside which trigger, after everything has moved.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped update_triggers(StepContext& step);

}  // namespace jostle::physics
