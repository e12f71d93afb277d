// SPDX-License-Identifier: MIT
//
// Lets TOI bodies search again after the path of one of them changed. Part of solve_continuous.
#pragma once

#include "physics/src/stages/continuous/impact_queue.h"
#include "physics/src/stages/continuous/toi_state.h"

namespace jostle::physics {

// The TOI body gets new candidates and searches its new path, if it still searches. TOI bodies that
// expected to hit it search their whole paths again. If it no longer searches, the other bodies on
// its path test it. Otherwise they need not: of two bodies, the one deflected last finds their
// impact, or an earlier one that deflects it again.
void update_dependents(ToiState& state, ImpactQueue& queue, std::size_t index);

}  // namespace jostle::physics
