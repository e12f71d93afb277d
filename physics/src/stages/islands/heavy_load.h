// SPDX-License-Identifier: MIT
//
// Heavy bodies that lie on light ones: their islands take SolverTier::heavy.
#pragma once

#include <span>

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Whether a body of the island rests on nothing but what is a hundred times lighter.
bool has_heavy_load(WorldState& world, const Island& island, Vec3 up);

// Of these bodies, which have begun to touch what is much lighter: those that rest on nothing else
// take their islands to that tier at once. Until the next look at all islands they would sink.
void raise_to_heavy_tier(WorldState& world, std::span<const std::uint32_t> bodies);

}  // namespace jostle::physics
