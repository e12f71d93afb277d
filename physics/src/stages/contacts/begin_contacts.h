// SPDX-License-Identifier: MIT
//
// Manifolds that may touch in this step enter the constraint graph. After wake_before_solve: what
// they meet asleep is awake by now.
//
// Reads: ContactScratch::begins, and the manifolds found. Writes: constraint graph, contacts,
// islands' colour sets. Leaves nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped begin_contacts(StepContext& step);

}  // namespace jostle::physics
