// SPDX-License-Identifier: MIT
//
// How hard the solver works on an island: its sub-steps per step and its sweeps over the points of
// a manifold. A rule chooses it from what the island is (stages/islands/prepare_islands.h);
// each tier has colour sets of its own, so all that hangs together by contacts or joints has the
// same tier.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "jostle/physics/defs.h"
#include "jostle/physics/limits.h"
#include "physics/src/foundation/check.h"

namespace jostle::physics {

// In rising order.
enum class SolverTier : std::uint8_t {
    flat,     // at most three layers, all slow
    low,      // what nothing is known of yet or moves: contacts learn the force of each point
    pile,     // most of it lies still, on more ground than it is high: like low, but stiffer; with
              // sleep, more sub-steps
    slender,  // stacks and walls: contacts learn the force of a manifold; moments would make it
              // sway
    tall,     // many layers of that, which at the same sub-steps lean and in the end fall
    heavy,    // a body rests on nothing but what is a hundred times lighter
    asleep,  // none: of contacts, not of islands. Its bodies sleep in place (state/partial_sleep.h)
};
inline constexpr int tier_count = 6;
inline constexpr std::array<SolverTier, tier_count> all_tiers = {
    SolverTier::flat,    SolverTier::low,  SolverTier::pile,
    SolverTier::slender, SolverTier::tall, SolverTier::heavy};
inline constexpr std::size_t index_of(SolverTier tier) {
    return static_cast<std::size_t>(tier);
}

// The islands of a tier lie in so many batches, whole: threads solve batches side by side, each
// alone, without waiting for one another. In a larger one they share the colours. In a world with a
// tolerance a batch is a rung: its islands take substeps_per_level
// (stages/islands/choose_substep_levels.h).
inline constexpr int batch_count = 4;
inline constexpr std::array<int, batch_count> substeps_per_level = {2, 6, 16, 48};
inline constexpr std::uint8_t initial_substep_level = 2;  // of an island of which nothing is known

// Which colours a contact is in: a set per tier and batch, and one for what sleeps in place.
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

// Sub-steps of an island. More of them keep a heap from slipping now and then: where bodies may
// sleep, what then rests saves more than they cost.
inline int substeps_of(SolverTier tier, const WorldDef& world) {
    ASSERT(tier != SolverTier::asleep && world.substeps >= 1);
    constexpr std::array<int, tier_count> halves = {1, 2, 2, 2, 4, 8};
    const int most = tier == SolverTier::pile && world.sleeping ? 3 : halves[index_of(tier)];
    return (world.substeps * most + 1) / 2;
}

inline bool controls_error(const WorldDef& world) {
    return world.tolerance > 0;
}
// ... of the islands of a set. With a tolerance what is slender, tall or heavy begins higher: a
// stack that its sub-steps cannot hold sways ever more, from nothing, and no comparison of two
// steps shows that before it does (six hold 33 layers, by what prepare_islands.h says of a wall).
// `halved`: half as many, where that leaves two; not of what is slender, tall or heavy, which needs
// them to stand; not with a tolerance.
inline int substeps_of(ColourSetKey set, const WorldDef& world, bool halved = false) {
    if (!controls_error(world)) {
        const int all = substeps_of(set.tier, world);
        const bool less = halved && set.tier < SolverTier::slender;
        return less ? std::min(all, std::max(2, (all + 1) / 2)) : all;
    }
    ASSERT(set.tier != SolverTier::asleep && set.batch < batch_count);
    constexpr std::array<int, tier_count> times = {1, 1, 1, 3, 8, 4};
    return std::min(substeps_per_level[set.batch] * times[index_of(set.tier)],
                    limits::max_substeps);
}

// Those between which an island does not change for its neighbours' sake.
inline bool is_usual(SolverTier tier) {
    return SolverTier::low <= tier && tier <= SolverTier::slender;
}

}  // namespace jostle::physics
