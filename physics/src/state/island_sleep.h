// SPDX-License-Identifier: MIT
//
// Whole islands fall asleep and wake. A sleeping island owns its bodies' warm records and
// manifolds; neither the awake set nor the constraint graph knows of them.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// If there are enough of them, its bodies wake asleep in place, with what presses on them: who
// disturbs the island wakes what that stirs. Not what joints tie to a kinematic body.
void wake_island(WorldState& world, std::uint32_t island, std::vector<BodyId>& woke);
// None of its bodies is asleep in place. `ended`: contacts that end by it.
void put_island_to_sleep(WorldState& world, std::uint32_t island, std::vector<ContactEnd>& ended);

}  // namespace jostle::physics
