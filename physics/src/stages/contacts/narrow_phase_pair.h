// SPDX-License-Identifier: MIT
//
// The narrow phase of one pair: where it touches, or by how much it is apart. A manifold that goes
// on is written into its lane at once; one that may begin is kept.
//
// Reads: bodies, shapes. Writes: the pair's own lanes and cache, so pairs may be looked at on many
// threads. Leaves in scratch: the check's result for update_touching; the manifolds found, in
// ContactScratch::fresh or parts, for begin_contacts.
#pragma once

#include "physics/src/stages/contacts/contact_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

void narrow_phase_pair(StepContext& step, NarrowPhaseTask& task);

}  // namespace jostle::physics
