// SPDX-License-Identifier: MIT
//
// Heavy bodies on light ones: their islands get SolverTier::heavy.
#pragma once

#include <span>

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Returns whether a body of the island rests only on bodies that are a hundred times lighter.
bool has_heavy_load(ContactGraph& stores, const Island& island, Vec3 up);

// `bodies`: bodies that have begun to touch a much lighter body. Those that rest on nothing else
// raise their islands to that tier immediately; until the next update of all islands they would
// sink.
void raise_to_heavy_tier(ContactGraph& stores, JointStore& joints,
                         std::span<const std::uint32_t> bodies);

}  // namespace jostle::physics
