// SPDX-License-Identifier: MIT
//
// The end of a step for one body. Touches this body only, so bodies may be finalized on many
// threads.
//
// Writes: pose, velocity and time at rest in its warm record, whose force is used up; its motion
// bound; new fat boxes of shapes that left theirs, of which no tree is told yet. Leaves in scratch:
// its flags and `before` in FinalizeScratch.
#pragma once

#include "physics/src/constraints/free_motion.h"
#include "physics/src/stages/finalize/finalize_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Makes space for the flags of each awake body; serially, before the first finalize_body of a step.
// `bouncing`: ContactScratch::bouncing.
void begin_finalize(const BodyStore& bodies, const std::vector<std::uint32_t>& bouncing,
                    FinalizeScratch& scratch);

// A state that is not finite, or is faster or further away than is sound (tuning.h), is not taken
// over: the body stays where it was, at rest, and is flagged for quarantine.
void finalize_body(StepContext& step, std::uint32_t awake_index, const FreeMotion& motion);

}  // namespace jostle::physics
