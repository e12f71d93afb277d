// SPDX-License-Identifier: MIT
//
// Continuous collision detection: prevents tunnelling. Bodies that moved far in the step
// (tuning::sweep_fraction of their inner radius) are swept along their path by conservative
// advancement. At the first hit, both bodies are moved to the time of impact, the impact is
// resolved there (restitution, friction, spin), and they continue through the rest of the step with
// their new velocities. Impacts are processed in the order of their times.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Reads: FinalizeScratch, contacts of fast bodies, ContactScratch::had_contacts, the broad phases.
// Writes: hit events; files wake requests for sleeping bodies that are hit. Leaves in scratch:
// ContinuousScratch::changed, the bodies deflected by impacts, for move_toi_bodies.
Skipped solve_continuous(StepContext& step);

// Moves the deflected bodies to the ends of their paths: warm records, motion bounds, fat boxes.
// Runs after wake_after_impacts, so the bodies that they hit are awake. Leaves nothing in scratch.
Skipped move_toi_bodies(StepContext& step);

}  // namespace jostle::physics
