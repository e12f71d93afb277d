// SPDX-License-Identifier: MIT
//
// Determines which shapes overlap which triggers, after all motion. Runs after the trees are
// updated (ThreadPool::finish() in step_world).
//
// Reads: current shapes, the broad phases, the TriggerStore of the previous step. Writes:
// TriggerStore, and trigger events. Leaves nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped update_triggers(StepContext& step);

}  // namespace jostle::physics
