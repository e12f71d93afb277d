// SPDX-License-Identifier: MIT
//
// Quarantine: no non-finite state leaves the step. finalize_body has left a diverged body at its
// previous pose, at rest. This stage reports it and resets the impulses and bounds of its contacts
// and joints.
//
// Reads: FinalizeScratch::not_finite. Writes: quarantine events; impulses of the body's joints; its
// manifolds, which are marked for a rebuild; its separation bounds; its motion bound. Leaves
// nothing in scratch.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped quarantine(StepContext& step);

}  // namespace jostle::physics
