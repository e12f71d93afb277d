// SPDX-License-Identifier: MIT
//
// Changes of tier and of batch: contacts move from set to set, and impulses, which are those
// of one sub-step, follow its length.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// The awake islands that manifolds tie to this one, itself the first: these share one store.
// Manifolds may tie islands that do not touch yet.
std::vector<std::uint32_t> coupled_islands(const WorldState& world, std::uint32_t island);

// The same for all islands at once: of many islands that takes as long as of a few. True until a
// manifold begins or ends; sets may change.
class CoupledIslands {
public:
    explicit CoupledIslands(const WorldState& world);
    // Rising. Those that are asleep are alone.
    std::span<const std::uint32_t> group_of(std::uint32_t island) const {
        const std::uint32_t first = first_[island];
        return std::span(members_).subspan(start_[first], start_[first + 1] - start_[first]);
    }

private:
    std::vector<std::uint32_t> first_;    // by island: the first of its group
    std::vector<std::uint32_t> start_;    // by first island of a group: in members_
    std::vector<std::uint32_t> members_;  // group after group
};

// `islands` are all that are tied to one of them.
void move_to_set(WorldState& world, std::span<const std::uint32_t> islands, ColourSetKey store);

// Multiplies all impulses of an awake island that warm-start the next step.
void scale_warm_start(WorldState& world, const Island& island, float scale);

// Before something ties two awake islands: gives both one store, that of the greater tier or,
// when those differ in nothing but what contacts learn, of the larger island.
void match_sets(WorldState& world, std::uint32_t a, std::uint32_t b);

}  // namespace jostle::physics
