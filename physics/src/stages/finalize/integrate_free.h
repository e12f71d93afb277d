// SPDX-License-Identifier: MIT
//
// Integrates bodies without manifolds and joints, and all kinematic bodies: an exact parabola under
// constant force, and a free rotation that conserves energy and angular momentum
// (constraints/free_motion.h). Runs after merge_islands, whose events need the velocities before
// the integration.
//
// Reads: SolverScratch::free, warm records, gravity. Writes: see finalize_body. Leaves in scratch:
// FinalizeScratch with space for all awake bodies, filled for the free ones.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped integrate_free(StepContext& step);

}  // namespace jostle::physics
