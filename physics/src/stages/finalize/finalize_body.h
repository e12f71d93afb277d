// SPDX-License-Identifier: MIT
//
// The end of a step for one body. Writes only this body, so bodies may be finalized on several
// threads.
//
// Writes: pose, velocity and rest time in its warm record, and clears its force; its motion bound;
// new fat boxes of shapes that left theirs, which are not yet in any tree. Leaves in scratch: its
// flags and `previous` in FinalizeScratch.
#pragma once

#include "physics/src/constraints/free_motion.h"
#include "physics/src/stages/finalize/finalize_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Allocates the flags of all awake bodies. Call serially, before the first finalize_body of a step.
// `bouncing`: ContactScratch::bouncing. `records_paths`: whether to fill
// FinalizeScratch::path_starts.
void begin_finalize(const BodyStore& bodies, const std::vector<std::uint32_t>& bouncing,
                    bool records_paths, FinalizeScratch& scratch);

// Rejects a state that is not finite, or too fast or too far away (tuning.h): the body stays at its
// previous pose, at rest, and is flagged for quarantine.
void finalize_body(StepContext& step, std::uint32_t awake_index, const FreeMotion& motion);

}  // namespace jostle::physics
