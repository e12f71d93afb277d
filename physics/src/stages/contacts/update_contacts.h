// SPDX-License-Identifier: MIT
//
// Narrow phase: where pairs touch. Chooses the pairs whose bodies could have met and the manifolds
// that moved too far to be reused (select_pairs), looks at each on any thread (narrow_phase_pair),
// and decides one after the other what follows (update_touching). All others keep what they have.
//
// Reads: bodies, shapes, pairs. Writes: separation bounds, manifolds that go
// on, contacts that end, wake requests. Leaves in scratch: ContactScratch::begins for
// begin_contacts, had_contacts for solve_continuous (ccd_policy.h).
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped update_contacts(StepContext& step);

}  // namespace jostle::physics
