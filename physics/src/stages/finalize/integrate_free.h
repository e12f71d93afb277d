// SPDX-License-Identifier: MIT
//
// Bodies that nothing holds (no manifold, no joint), and all kinematic ones: an exact parabola
// under constant force, and a free rotation that keeps energy and angular momentum
// (constraints/free_motion.h). After merge_islands, whose events want the velocities from before.
//
// Reads: SolverScratch::free, warm records, gravity. Writes: what finalize_body does. Leaves in
// scratch: FinalizeScratch with space for all awake bodies, filled for those that are free.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped integrate_free(StepContext& step);

}  // namespace jostle::physics
