// SPDX-License-Identifier: MIT
//
// Islands grow and part: which bodies belong to one. Sleep is elsewhere (state/island_sleep.h).
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/state/world_state.h"

namespace jostle::physics {

std::uint32_t create_island(WorldState& world);
void add_to_island(WorldState& world, std::uint32_t island, std::uint32_t body);
// Frees the island when its last body leaves.
void remove_from_island(WorldState& world, std::uint32_t body);
// The smaller joins the larger; of equals the higher index joins the lower. Both awake.
void join_islands(WorldState& world, std::uint32_t a, std::uint32_t b);
// Cuts an awake island into what still hangs together by touching contacts and joints. What hangs
// together with its first body keeps the island's index.
void split_island(WorldState& world, std::uint32_t island);
// Rising. Where few are awake among many that sleep, these are not looked at.
void find_awake_islands(const WorldState& world, std::vector<std::uint32_t>& islands);

}  // namespace jostle::physics
