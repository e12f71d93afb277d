// SPDX-License-Identifier: MIT
//
// Searches the paths of TOI bodies for their first impacts. Part of solve_continuous.
#pragma once

#include <cstdint>

#include "physics/src/stages/continuous/impact_queue.h"
#include "physics/src/stages/continuous/toi_state.h"

namespace jostle::physics {

// Sweeps a TOI body against one shape: replaces the first known impact of a TOI body if it hits the
// shape before, or at the same time and harder. Writes the TOI body only, so different TOI bodies
// can be swept in parallel.
void sweep_against(const ToiState& state, ToiBody& t, std::uint32_t shape);

// Searches for all TOI bodies in ToiState::to_search, on all threads, and enters their next events
// in the order of the list. A search reads the paths of other bodies and writes its own TOI body
// only.
void find_impacts(ToiState& state, ImpactQueue& queue);

}  // namespace jostle::physics
