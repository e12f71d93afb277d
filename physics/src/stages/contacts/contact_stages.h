// SPDX-License-Identifier: MIT
//
// The parts of update_contacts, in execution order.
#pragma once

#include "physics/src/stages/contacts/contact_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Selects the pairs for the narrow phase of this step: pairs whose separation bound may be used up,
// and pairs whose manifold must be rebuilt.
//
// Reads: motion bounds of bodies, flags of the constraint graph. Writes: separation bounds; used-up
// bounds are removed from the list. Leaves in scratch: ContactScratch::tasks with space for their
// results, and had_contacts for narrow_phase_pair and solve_continuous (ccd_policy.h).
void select_pairs(StepContext& step);

// The narrow phase of one pair: its contact points, or its separation. A continuing manifold is
// written into its lane immediately; a new one is stored in scratch.
//
// Reads: bodies, shapes. Writes: the pair's own lanes and cache, so different pairs may run on
// different threads. Leaves in scratch: the task's result for update_touching; the manifolds found,
// in ContactScratch::fresh or children, for begin_contacts.
void narrow_phase_pair(StepContext& step, NarrowPhaseTask& task);

// Applies the result of a narrow-phase test: the manifold of the pair continues, begins or ends, or
// the pair gets a separation bound. Serial, in the order of the tasks.
//
// Reads: ContactScratch::tasks and their results. Writes: contacts, separation bounds, constraint
// graph, flags of islands that may be split, end events; files wake requests for sleeping bodies
// that are touched. Leaves in scratch: ContactScratch::begins for begin_contacts.
void update_touching(StepContext& step);

}  // namespace jostle::physics
