// SPDX-License-Identifier: MIT
//
// Finds the shapes that fast bodies may hit on their predicted paths: the shapes in pairs with
// them, except those that a separation bound still keeps apart after the step. Part of
// solve_continuous. Reads the world, FinalizeScratch and SweptMotions, writes ContinuousScratch.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/stages/continuous/swept_motions.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// `fast`: awake indices of the fast bodies. Writes for each of them, to
// ContinuousScratch::sweep_candidates, the shapes in no particular order, each once per pair with a
// shape of the body, and to `manifolds` the shape pairs with a manifold.
void find_sweep_candidates(StepContext& step, const SweptMotions& motions,
                           const std::vector<std::uint32_t>& fast);

}  // namespace jostle::physics
