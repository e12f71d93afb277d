// SPDX-License-Identifier: MIT
//
// Adds manifolds that may touch in this step to the constraint graph. Runs after wake_before_solve,
// so their bodies are awake.
//
// Reads: ContactScratch::begins, and the manifolds found. Writes: constraint graph, contacts,
// colour sets of islands. Leaves nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped begin_contacts(StepContext& step);

}  // namespace jostle::physics
