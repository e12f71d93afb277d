// SPDX-License-Identifier: MIT
//
// Changes of effort: manifolds move from store to store, and impulses, which are those of one
// sub-step, follow its length.
#pragma once

#include <cstdint>
#include <vector>

#include "state/world_state.h"

namespace jostle::physics {

// The awake islands that manifolds tie to this one, itself the first: these share one effort.
// Manifolds may tie islands that do not touch yet.
std::vector<std::uint32_t> tied_islands(const WorldState& world, std::uint32_t island);

// `islands` are all that tied_islands() gives for one of them.
void set_effort(WorldState& world, const std::vector<std::uint32_t>& islands, Effort effort);

// Multiplies all impulses of an awake island that warm-start the next step.
void scale_loads(WorldState& world, const Island& island, float scale);

// Before something ties two awake islands: gives both one effort, the greater of the two or, when
// they differ in nothing but what contacts learn, that of the larger island.
void level_efforts(WorldState& world, std::uint32_t a, std::uint32_t b);

}  // namespace jostle::physics
