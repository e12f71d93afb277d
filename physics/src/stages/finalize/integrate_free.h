// SPDX-License-Identifier: MIT
//
// Bodies without a manifold: exact parabola under constant force, symmetric free rotation that
// keeps the angular momentum. Writes pose and velocity of the warm records.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped integrate_free(StepContext& step);

}  // namespace jostle::physics
