// SPDX-License-Identifier: MIT
//
// Which pairs the narrow phase looks at in this step: those whose separation bound may be used up,
// and those whose manifold is to be rebuilt.
//
// Reads: bodies, the constraint graph's flags. Writes: separation bounds. Leaves in scratch:
// ContactScratch::checks with space for their results, and had_contacts.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

void choose_checks(StepContext& step);

}  // namespace jostle::physics
