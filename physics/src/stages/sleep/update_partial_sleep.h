// SPDX-License-Identifier: MIT
//
// Resting parts of islands that do not rest as a whole: what has been still for long, and touches
// nothing that has not, is frozen. It thaws when something that touches it moves or when the force
// at one of its contacts with what moves is no longer what it was. Load by load a change goes as
// far as it is felt.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

void put_parts_to_sleep(StepContext& step);

// Before anything is solved: those who must thaw do.
void wake_disturbed_parts(StepContext& step);

// When it is known which touches ended in this step: nothing of that is left for the next one,
// which may be another world's that was loaded.
void wake_unsupported_parts(StepContext& step);

}  // namespace jostle::physics
