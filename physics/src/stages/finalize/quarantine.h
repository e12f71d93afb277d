// SPDX-License-Identifier: MIT
//
// Nothing that is not finite leaves the step. finalize_body has left a body whose state ran away
// where it was before the step, at rest; here it is reported, and its contacts and joints forget
// what they bore and where they were.
//
// Reads: FinalizeScratch::not_finite. Writes: quarantine events; impulses of the body's joints; its
// manifolds, which are marked to be rebuilt; its separation bounds; its motion bound. Leaves
// nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped quarantine(StepContext& step);

}  // namespace jostle::physics
