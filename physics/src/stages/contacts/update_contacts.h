// SPDX-License-Identifier: MIT
//
// Narrow phase: finds the contact points of pairs. Selects the pairs whose bodies may have touched
// and the manifolds that moved too far to be reused (select_pairs), tests each on any thread
// (narrow_phase_pair), and applies the results serially (update_touching). All other pairs are
// unchanged.
//
// Reads: bodies, shapes, pairs. Writes: separation bounds, continuing manifolds, ended contacts,
// wake requests. Leaves in scratch: ContactScratch::begins for begin_contacts, had_contacts for
// solve_continuous (ccd_policy.h).
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

Skipped update_contacts(StepContext& step);

}  // namespace jostle::physics
