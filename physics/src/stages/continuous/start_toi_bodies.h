// SPDX-License-Identifier: MIT
//
// Turns fast bodies into TOI bodies, with the shapes that they may hit. Most fast bodies have no
// such shapes and need no sweep. Part of solve_continuous.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/stages/continuous/swept_motions.h"
#include "physics/src/stages/continuous/toi_state.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Finds the shapes that fast bodies may hit on their predicted paths: the shapes in pairs with
// them, except those that a separation bound still keeps apart after the step. Reads the world,
// FinalizeScratch and SweptMotions.
//
// `fast`: awake indices of the fast bodies. Writes for each of them, to
// ContinuousScratch::sweep_candidates, the shapes in no particular order, each once per pair with a
// shape of the body, and to `manifolds` the shape pairs with a manifold.
void find_sweep_candidates(StepContext& step, const SweptMotions& motions,
                           const std::vector<std::uint32_t>& fast);

// Adds the fast bodies that may hit something on their paths of the whole step. The candidates of a
// body on its predicted path are among its contacts; a body that was deflected from it searches the
// trees.
void start_toi_bodies(ToiState& state);

// Adds the fast bodies without a TOI body whose paths overlap a box, by ascending body index. The
// box is a copy because it may belong to a TOI body, which moves in memory.
void start_toi_bodies_in(ToiState& state, Aabb box);

}  // namespace jostle::physics
