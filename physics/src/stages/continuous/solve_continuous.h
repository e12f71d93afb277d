// SPDX-License-Identifier: MIT
//
// Nothing passes through anything. Bodies that moved far in the step (tuning::sweep_fraction of
// their inner radius) are swept along their way by conservative advancement. At the first thing
// that one meets, both are put to that moment, the impact is resolved there (restitution, friction,
// spin), and they live the rest of the step with their new velocities. Impacts are taken in the
// order of their times.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Reads: FinalizeScratch, contacts of fast bodies, ContactScratch::had_contacts, the broad phases.
// Writes: hit events; files wake requests for what is met asleep. Leaves in scratch:
// ContinuousScratch::changed for move_toi_bodies, the bodies that impacts sent another way.
Skipped solve_continuous(StepContext& step);

// Puts those where their ways end: warm records, motion bounds, fat boxes. After
// wake_after_impacts: whom they met is awake by then. Leaves nothing in scratch.
Skipped move_toi_bodies(StepContext& step);

}  // namespace jostle::physics
