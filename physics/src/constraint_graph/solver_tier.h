// SPDX-License-Identifier: MIT
//
// Solver effort for an island: its sub-steps per step and its sweeps over the points of a manifold.
// A rule chooses the tier from the properties of the island (prepare_islands in stages/stages.h).
// Each tier has its own colour sets, so all bodies connected by contacts or joints have the same
// tier.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "jostle/base/check.h"
#include "jostle/physics/defs.h"
#include "jostle/physics/limits.h"

namespace jostle::physics {

// In ascending order, except `asleep`. Saved worlds contain the values.
enum class SolverTier : std::uint8_t {
    flat,  // at most three layers, all slow
    low,   // new or moving islands: contacts learn the force of each point
    // Mostly at rest, wider than high. Like low but stiffer; with sleep, more sub-steps.
    pile,
    // Stacks and walls. Contacts learn the force of a whole manifold; moments would make it sway.
    slender,
    tall,    // slender with many layers, which lean and finally fall with the same sub-steps
    heavy,   // a body rests only on bodies that are a hundred times lighter
    asleep,  // contacts only, not islands: bodies that sleep in place (state/partial_sleep.h)
    // Few bodies, of which some carry many times their own mass: all contacts of the island are
    // solved together instead of one after another (constraints/contact_group).
    direct,
};
inline constexpr int tier_count = 7;  // without `asleep`
inline constexpr std::array<SolverTier, tier_count> all_tiers = {
    SolverTier::flat, SolverTier::low,   SolverTier::pile,  SolverTier::slender,
    SolverTier::tall, SolverTier::heavy, SolverTier::direct};
// Position in all_tiers; `asleep` follows.
inline constexpr std::size_t index_of(SolverTier tier) {
    if (tier == SolverTier::asleep) return tier_count;
    return tier == SolverTier::direct ? tier_count - 1 : static_cast<std::size_t>(tier);
}

// The islands of a tier are distributed over this many batches, each island in one batch. Threads
// solve batches in parallel without waiting for each other. In a larger island they share the
// colours. In a world with a tolerance a batch is a sub-step level: its islands take
// substeps_per_level sub-steps (choose_substep_levels in stages/islands/island_stages.h). In a
// world with small bodies or high gravity a batch is a size level: its islands take
// substeps_per_size times the sub-steps (choose_size_levels).
inline constexpr int batch_count = 4;
inline constexpr std::array<int, batch_count> substeps_per_level = {2, 6, 16, 48};
inline constexpr std::uint8_t initial_substep_level = 2;  // for an island without history
inline constexpr std::array<int, batch_count> substeps_per_size = {1, 3, 8, 24};
inline constexpr int max_substeps_by_size = 4 * limits::max_substeps;

// Identifies a colour set: one per tier and batch, and one for contacts that sleep in place.
struct ColourSetKey {
    SolverTier tier = SolverTier::low;
    std::uint8_t batch = 0;
    bool operator==(const ColourSetKey&) const = default;
};
inline constexpr int solved_set_count = tier_count * batch_count;
inline constexpr int colour_set_count = solved_set_count + 1;

inline constexpr std::size_t index_of(ColourSetKey key) {
    ASSERT(key.batch < (key.tier == SolverTier::asleep ? 1 : batch_count));
    return index_of(key.tier) * batch_count + key.batch;
}
inline constexpr ColourSetKey asleep_set = {SolverTier::asleep, 0};
static_assert(index_of(asleep_set) == colour_set_count - 1);

// Sub-steps of an island. More sub-steps keep a pile from slipping occasionally. If bodies may
// sleep, the bodies that come to rest save more time than the sub-steps cost.
inline int substeps_of(SolverTier tier, const WorldDef& world) {
    ASSERT(tier != SolverTier::asleep && world.substeps >= 1);
    constexpr std::array<int, tier_count + 1> halves = {1, 2, 2, 2, 4, 8, 1};
    const int most = tier == SolverTier::pile && world.sleeping ? 3 : halves[index_of(tier)];
    ASSERT(most >= 1);
    return (world.substeps * most + 1) / 2;
}

inline bool controls_error(const WorldDef& world) {
    return world.tolerance > 0;
}
// Sub-steps of the islands of a set. With a tolerance, slender, tall and heavy islands start
// higher: a stack with too few sub-steps sways with growing amplitude, and comparing two steps does
// not reveal that in advance (six sub-steps hold 33 layers; see prepare_islands about walls).
// `halved`: half the sub-steps, but at least two. It does not apply to slender, tall or heavy
// islands, which need them to stand, nor with a tolerance. `by_size`: the batch is a size level.
inline int substeps_of(ColourSetKey set, const WorldDef& world, bool halved = false,
                       bool by_size = false) {
    if (!controls_error(world)) {
        const int all = substeps_of(set.tier, world);
        const bool less = halved && set.tier < SolverTier::slender;
        const int some = less ? std::min(all, std::max(2, (all + 1) / 2)) : all;
        return by_size ? std::max(some, std::min(some * substeps_per_size[set.batch],
                                                 max_substeps_by_size))
                       : some;
    }
    ASSERT(set.tier != SolverTier::asleep && set.batch < batch_count);
    constexpr std::array<int, tier_count + 1> times = {1, 1, 1, 3, 8, 4, 1};
    return std::min(substeps_per_level[set.batch] * times[index_of(set.tier)],
                    limits::max_substeps);
}

// Tiers of equal priority: if two such islands touch, the smaller one takes the tier of the larger.
inline bool is_usual(SolverTier tier) {
    return SolverTier::low <= tier && tier <= SolverTier::slender;
}

}  // namespace jostle::physics
