// SPDX-License-Identifier: MIT
//
// Turns fast bodies into TOI bodies, with the shapes that they may hit. Most fast bodies have no
// such shapes and need no sweep. Part of solve_continuous.
#pragma once

#include "physics/src/stages/continuous/toi_state.h"

namespace jostle::physics {

// Adds the fast bodies that may hit something on their paths of the whole step. The candidates of a
// body on its predicted path are among its contacts; a body that was deflected from it searches the
// trees.
void start_toi_bodies(ToiState& state);

// Adds the fast bodies without a TOI body whose paths overlap a box, by ascending body index. The
// box is a copy because it may belong to a TOI body, which moves in memory.
void start_toi_bodies_in(ToiState& state, Aabb box);

}  // namespace jostle::physics
