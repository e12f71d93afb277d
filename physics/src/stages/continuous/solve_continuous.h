// SPDX-License-Identifier: MIT
//
// Nothing passes through anything: bodies that moved further than their own thickness are swept
// along their way. At the first thing they meet both are put to that moment, the impact is resolved
// there (restitution, friction, spin), and the rest of the step is lived with the new velocities;
// impacts are taken in the order of their times.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

// Reads: FinalizeScratch. Files wake requests for what is met asleep, and hit events. Leaves in
// scratch: ContinuousScratch::changed, the bodies that impacts sent another way.
Skipped solve_continuous(StepContext& step);

// Puts those where their ways end. After wake_bodies: whom they met is awake by then.
Skipped place_toi_bodies(StepContext& step);

}  // namespace jostle::physics
