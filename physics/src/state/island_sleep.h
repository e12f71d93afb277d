// SPDX-License-Identifier: MIT
//
// Falling asleep and waking of whole islands. A sleeping island owns the warm records and the
// manifolds of its bodies, which are in neither the awake set nor the constraint graph.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Wakes an island. If it has enough bodies, they wake asleep in place, with the forces at their
// contacts, so that a disturbance wakes only its surroundings. Bodies connected by joints to a
// kinematic body wake completely.
void wake_island(WorldState& world, std::uint32_t island, std::vector<BodyId>& woke);
// Puts an island to sleep. Precondition: none of its bodies is asleep in place. Appends the
// contacts that end to `ended`.
void put_island_to_sleep(WorldState& world, std::uint32_t island, std::vector<ContactEnd>& ended);

}  // namespace jostle::physics
