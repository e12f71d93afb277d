// SPDX-License-Identifier: MIT
//
// The last stage: events become what World::events() shows, each list in order of ids.
//
// Reads: EventStore as the stages and calls between steps filled it; of contacts that are to be
// reported in every step, impulses and flags in the constraint graph. Writes: EventStore, sorted
// and with EventStore::contacts. Leaves nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped publish_events(StepContext& step);

}  // namespace jostle::physics
