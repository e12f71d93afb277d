// SPDX-License-Identifier: MIT
//
// Bodies wake: with their island if that sleeps, in place if only a part of it does.
#pragma once

#include "state/world_state.h"

namespace jostle::physics {

// Makes sure that a dynamic body moves.
void ensure_awake(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke);

// Between steps, when a caller does something to a body: ... and its time at rest begins anew.
void wake_body(WorldState& world, std::uint32_t body);
// Everything that touches the body, is near it or is jointed to it.
void wake_neighbours(WorldState& world, std::uint32_t body);

}  // namespace jostle::physics
