// SPDX-License-Identifier: MIT
//
// Waking of bodies: with their island if it sleeps, in place if only a part of it sleeps.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Ensures that a dynamic body is awake.
void ensure_awake(WorldState& world, std::uint32_t body, std::vector<BodyId>& woke);

// Applies and clears WorldState::wake_requests in order of bodies: first wakes sleeping islands,
// then bodies that this leaves asleep in place.
void apply_wake_requests(WorldState& world, std::vector<BodyId>& woke);

// Wakes a body that a caller changes between steps, and resets its time at rest.
void wake_body(WorldState& world, std::uint32_t body);
// Wakes all bodies that touch the body, are close to it or are connected to it by joints.
void wake_neighbours(WorldState& world, std::uint32_t body);

}  // namespace jostle::physics
