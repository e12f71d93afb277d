// SPDX-License-Identifier: MIT
//
// What follows from a look at a pair: its manifold goes on, begins or ends, or it gets a separation
// bound. Serial, in order of the checks.
//
// Reads: ContactScratch::checks and what they found. Writes: contacts, separation bounds,
// constraint graph, the marks of islands that may be split, end events; files wake requests for
// what is met asleep. Leaves in scratch: ContactScratch::begins for begin_contacts.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

void update_touching(StepContext& step);

}  // namespace jostle::physics
