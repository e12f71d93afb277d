// SPDX-License-Identifier: MIT
//
// The end of a step for solved bodies: writes the solver's float results back to the double records
// (finalize_body). Bodies that were not solved were finalized in integrate_free.
//
// Reads: SolverScratch::hot, bodies and spin_axes. Writes: see finalize_body; and ShapeStore::moved
// for all shapes that left their fat box. Updates the moving broad phase with their new boxes,
// concurrently with the following stages: a stage that queries it must call ThreadPool::finish()
// first. Leaves in scratch: FinalizeScratch, for solve_continuous and quarantine.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped finalize(StepContext& step);

}  // namespace jostle::physics
