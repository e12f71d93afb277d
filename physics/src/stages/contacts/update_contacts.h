// SPDX-License-Identifier: MIT
//
// Narrow phase: where pairs touch. Looks at the waiting pairs whose bodies could have met and at
// the manifolds that moved too far to be reused; all others keep what they have.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped update_contacts(StepContext& step);

}  // namespace jostle::physics
