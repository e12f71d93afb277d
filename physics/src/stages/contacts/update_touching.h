// SPDX-License-Identifier: MIT
//
// Applies the result of a narrow-phase test: the manifold of the pair continues, begins or ends, or
// the pair gets a separation bound. Serial, in the order of the tasks.
//
// Reads: ContactScratch::tasks and their results. Writes: contacts, separation bounds, constraint
// graph, flags of islands that may be split, end events; files wake requests for sleeping bodies
// that are touched. Leaves in scratch: ContactScratch::begins for begin_contacts.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

void update_touching(StepContext& step);

}  // namespace jostle::physics
