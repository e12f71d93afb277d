// SPDX-License-Identifier: MIT
//
// Bodies wake: with their island if that sleeps, in place if only a part of it does.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Makes sure that a dynamic body moves.
void ensure_awake(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke);

// Wakes those of whom `WorldState::wake_requests` speak, in order of bodies, and forgets the
// requests. First the islands that sleep, then what that leaves asleep in place.
void apply_wake_requests(WorldState& world, std::vector<BodyId>& woke);

// Between steps, when a caller does something to a body: ... and its time at rest begins anew.
void wake_body(WorldState& world, std::uint32_t body);
// Everything that touches the body, is near it or is jointed to it.
void wake_neighbours(WorldState& world, std::uint32_t body);

}  // namespace jostle::physics
