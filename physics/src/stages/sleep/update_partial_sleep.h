// SPDX-License-Identifier: MIT
//
// Parts of islands that do not rest as a whole: what has been still for long, and touches nothing
// that has not, falls asleep in place. It is to wake when something that touches it moves, or when
// the force at one of its contacts with what moves is no longer what it was. Load by load a change
// goes as far as it is felt.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

// Reads: SleepScratch::longest, times at rest, loads. Writes: sleep in place, and its events.
void put_parts_to_sleep(StepContext& step);

// Before anything is solved: files wake requests for what is disturbed.
void file_disturbances(StepContext& step);

}  // namespace jostle::physics
