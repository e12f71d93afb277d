// SPDX-License-Identifier: MIT
//
// The end of a step for the bodies that were solved: what the solver left in float goes back to the
// double records (finalize_body). Those that were not solved integrate_free has finalized before.
//
// Reads: SolverScratch::hot, bodies and spin_axes. Writes: what finalize_body does, and
// ShapeStore::moved for all shapes that left their fat box. Tells the moving broad phase of their
// new boxes, beside the stages that follow: who asks it calls ThreadPool::finish() before. Leaves
// in scratch: FinalizeScratch, for solve_continuous and quarantine.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped finalize(StepContext& step);

}  // namespace jostle::physics
