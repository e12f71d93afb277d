// SPDX-License-Identifier: MIT
//
// Parts of islands that do not rest as a whole. What has been still for long, and touches nothing
// that has not, falls asleep in place. It wakes when something that touches it moves, or when the
// force at one of its contacts with what is awake is no longer what it was. So a change of load
// goes from body to body, as far as it is felt.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// In update_sleep, every eighth step. Reads: SleepScratch::longest, times at rest, contacts,
// joints. Writes: which bodies sleep in place, the loads that they bear, and sleep events.
void put_parts_to_sleep(StepContext& step);

// In wake_before_solve. Reads: bodies that sleep in place and what touches them. Files wake
// requests for those that are disturbed.
void request_disturbed_wakes(StepContext& step);

}  // namespace jostle::physics
