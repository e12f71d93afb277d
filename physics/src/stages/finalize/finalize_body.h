// SPDX-License-Identifier: MIT
//
// The end of a step for one body: new pose and velocity into its warm record, travel, rest time,
// and whether it left its fat boxes. Touches this body only, so bodies may be finalized on many
// threads.
#pragma once

#include "constraints/free_motion.h"
#include "stages/finalize/finalize_scratch.h"
#include "stages/step_context.h"

namespace jostle::physics {

// Makes space for the flags of each awake body; serially, before the first finalize_body of a step.
void begin_finalize(const BodyStore& bodies, FinalizeScratch& scratch);

// A state that is not finite is not taken over: the body stays where it was, at rest, and is
// flagged for quarantine.
void finalize_body(StepContext& step, std::uint32_t awake_index, const FreeMotion& motion);

}  // namespace jostle::physics
