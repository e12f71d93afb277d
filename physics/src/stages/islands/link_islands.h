// SPDX-License-Identifier: MIT
//
// What hangs together: contacts that began or ended to touch bind or unbind islands, and become
// events.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped link_islands(StepContext& step);

}  // namespace jostle::physics
