// SPDX-License-Identifier: MIT
//
// Manifolds that may touch in this step enter the constraint graph. After wake_bodies: both bodies
// are awake.
//
// Reads: ContactScratch::begins, and the manifolds found. Writes: constraint graph, contacts,
// islands' colour sets.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

Skipped begin_contacts(StepContext& step);

}  // namespace jostle::physics
