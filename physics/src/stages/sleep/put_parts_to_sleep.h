// SPDX-License-Identifier: MIT
//
// Partial sleep of islands that do not rest as a whole. A body that has been at rest for long and
// touches only such bodies falls asleep in place. It wakes when a body that touches it moves, or
// when the force at one of its contacts with an awake body changes. A change of load therefore
// propagates from body to body as far as it has an effect.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Called by update_sleep every eighth step. Reads: SleepScratch::longest, rest times, contacts,
// joints. Writes: which bodies sleep in place, the loads that they carry, and sleep events.
void put_parts_to_sleep(StepContext& step);

// Called by wake_before_solve. Reads: bodies that sleep in place and their contacts. Files wake
// requests for disturbed bodies.
void request_disturbed_wakes(StepContext& step);

}  // namespace jostle::physics
