// SPDX-License-Identifier: MIT
//
// Nothing that is not a number leaves the step: a body whose state ran away is put to rest where it
// last was, and reported.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped quarantine(StepContext& step);

}  // namespace jostle::physics
