// SPDX-License-Identifier: MIT
//
// The sub-step loop: integrates velocities from forces, joints and contacts, and positions from
// velocities. Soft contacts with relaxation (Catto, "Soft Constraints", GDC 2011; "Solver2D",
// 2024).
//
// Reads: awake bodies, joints, Island::colour_set, StepContext::contacts. Writes: impulses, gaps
// and flags (touching_now, needs_rebuild) in the constraint graph, impulses and loads of joints;
// broken joints with their events. Does not change the warm records. Leaves in scratch:
// SolverScratch::hot, bodies and spin_axes for finalize, free for integrate_free, jointed for
// update_sleep; bodies and free are also set if there is nothing to solve.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped solve_constraints(StepContext& step);

}  // namespace jostle::physics
