// SPDX-License-Identifier: MIT
//
// What follows from a look at a pair: its manifold goes on, begins or ends, or it gets a separation
// bound. Serial, in order of the checks.
//
// Reads: ContactScratch::checks and what they found. Writes: contacts, constraint graph, islands'
// marks; files wake requests for what is met asleep. Leaves in scratch: ContactScratch::begins.
#pragma once

#include "stages/step_context.h"

namespace jostle::physics {

void decide_contacts(StepContext& step);

}  // namespace jostle::physics
