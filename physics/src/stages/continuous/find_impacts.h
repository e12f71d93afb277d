// SPDX-License-Identifier: MIT
//
// Searches the paths of TOI bodies for their first impacts. Part of solve_continuous.
#pragma once

#include "physics/src/stages/continuous/impact_queue.h"
#include "physics/src/stages/continuous/toi_state.h"

namespace jostle::physics {

// Searches for all TOI bodies in ToiState::to_search, on all threads, and enters their next events
// in the order of the list. A search reads the paths of other bodies and writes its own TOI body
// only.
void find_impacts(ToiState& state, ImpactQueue& queue);

}  // namespace jostle::physics
