// SPDX-License-Identifier: MIT
//
// Which shapes fast bodies may meet on the way that was foreseen: those of the pairs that they are
// in, but for what a separation bound still keeps apart after the step. Part of solve_continuous:
// reads the world, FinalizeScratch and SweptMotions, writes ContinuousScratch.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/stages/continuous/swept_motions.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// `fast`: awake indices of the fast bodies. Leaves in ContinuousScratch::ahead, for each of them,
// the shapes in no order, each as often as shapes of its own are in pairs with it, and in manifolds
// the pairs of shapes that have one.
void find_sweep_candidates(StepContext& step, const SweptMotions& motions,
                           const std::vector<std::uint32_t>& fast);

}  // namespace jostle::physics
