// SPDX-License-Identifier: MIT
//
// Membership of bodies in islands, which merge and split. Sleep is in state/island_sleep.h.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/state/world_state.h"

namespace jostle::physics {

std::uint32_t create_island(IslandStore& islands, const WorldDef& def);
void add_to_island(BodySets& sets, std::uint32_t island, std::uint32_t body);
// Frees the island if its last body leaves.
void remove_from_island(BodySets& sets, std::uint32_t body);
// Merges the smaller island into the larger one; of equal islands the higher index into the lower
// one. Both must be awake.
void join_islands(ContactGraph& stores, JointStore& joints, std::uint32_t a, std::uint32_t b);
// Splits an awake island into its connected components by touching contacts and joints. The
// component of its first body retains the island's index.
void split_island(WorldState& world, std::uint32_t island);
// Returns the awake islands in ascending order. If few of many islands are awake, sleeping islands
// are not visited.
void find_awake_islands(const BodySets& sets, std::vector<std::uint32_t>& islands);

}  // namespace jostle::physics
