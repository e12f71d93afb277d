// SPDX-License-Identifier: MIT
//
// Selects the pairs for the narrow phase of this step: pairs whose separation bound may be used up,
// and pairs whose manifold must be rebuilt.
//
// Reads: motion bounds of bodies, flags of the constraint graph. Writes: separation bounds; used-up
// bounds are removed from the list. Leaves in scratch: ContactScratch::tasks with space for their
// results, and had_contacts for narrow_phase_pair and solve_continuous (ccd_policy.h).
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

void select_pairs(StepContext& step);

}  // namespace jostle::physics
