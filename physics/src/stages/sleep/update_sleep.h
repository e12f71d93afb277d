// SPDX-License-Identifier: MIT
//
// Resting islands leave the awake set.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped update_sleep(StepContext& step);

}  // namespace jostle::physics
