// SPDX-License-Identifier: MIT
//
// The narrow phase of one pair: its contact points, or its separation. A continuing manifold is
// written into its lane immediately; a new one is stored in scratch.
//
// Reads: bodies, shapes. Writes: the pair's own lanes and cache, so different pairs may run on
// different threads. Leaves in scratch: the task's result for update_touching; the manifolds found,
// in ContactScratch::fresh or children, for begin_contacts.
#pragma once

#include "physics/src/stages/contacts/contact_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

void narrow_phase_pair(StepContext& step, NarrowPhaseTask& task);

}  // namespace jostle::physics
