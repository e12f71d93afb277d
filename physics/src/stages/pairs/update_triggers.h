// SPDX-License-Identifier: MIT
//
// What is inside which trigger, after everything has moved. After the trees were told of that
// (ThreadPool::finish() in step_world).
//
// Reads: shapes where they are now, the broad phases, TriggerStore of the step before. Writes:
// TriggerStore, and trigger events. Leaves nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped update_triggers(StepContext& step);

}  // namespace jostle::physics
