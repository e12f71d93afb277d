// SPDX-License-Identifier: MIT
//
// Which pairs the narrow phase looks at in this step: those whose separation bound may be used up,
// and those whose manifold is to be rebuilt.
//
// Reads: motion bounds of bodies, the constraint graph's flags. Writes: separation bounds, of which
// those that are used up leave the list. Leaves in scratch: ContactScratch::checks with space for
// their results, and had_contacts for narrow_phase_pair and solve_continuous (ccd_policy.h).
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

void select_pairs(StepContext& step);

}  // namespace jostle::physics
