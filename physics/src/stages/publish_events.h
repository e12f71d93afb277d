// SPDX-License-Identifier: MIT
//
// The last stage: makes events available through World::events(), each list sorted by ids.
//
// Reads: EventStore as filled by the stages and by calls between steps; for contacts with
// report_stays, impulses and flags in the constraint graph. Writes: EventStore, sorted and with
// EventStore::contacts. Leaves nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped publish_events(StepContext& step);

}  // namespace jostle::physics
