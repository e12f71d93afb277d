// SPDX-License-Identifier: MIT
//
// Sweeps a TOI body against one shape. Part of solve_continuous.
#pragma once

#include <cstdint>

#include "physics/src/stages/continuous/toi_state.h"

namespace jostle::physics {

// Replaces the first known impact of a TOI body if it hits the shape before, or at the same time
// and harder. Writes the TOI body only, so different TOI bodies can be swept in parallel.
void sweep_against(const ToiState& state, ToiBody& t, std::uint32_t shape);

}  // namespace jostle::physics
