// SPDX-License-Identifier: MIT
//
// Changes of tier and of batch: contacts move from set to set, and impulses, which are those
// of one sub-step, follow its length.
#pragma once

#include <cstdint>
#include <vector>

#include "state/world_state.h"

namespace jostle::physics {

// The awake islands that manifolds tie to this one, itself the first: these share one store.
// Manifolds may tie islands that do not touch yet.
std::vector<std::uint32_t> tied_islands(const WorldState& world, std::uint32_t island);
// ... of many: none that is marked in `seen`, by island; marks what it finds.
std::vector<std::uint32_t> tied_islands(const WorldState& world, std::uint32_t island,
                                        std::vector<bool>& seen);

// `islands` are all that tied_islands() gives for one of them.
void move_to_set(WorldState& world, const std::vector<std::uint32_t>& islands, ColourSetKey store);

// Multiplies all impulses of an awake island that warm-start the next step.
void scale_warm_start(WorldState& world, const Island& island, float scale);

// Before something ties two awake islands: gives both one store, that of the greater tier or,
// when those differ in nothing but what contacts learn, of the larger island.
void match_sets(WorldState& world, std::uint32_t a, std::uint32_t b);

}  // namespace jostle::physics
