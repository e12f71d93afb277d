// SPDX-License-Identifier: MIT
//
// How hard the solver works on an island: its sub-steps per step and its sweeps over the points of
// a manifold. A rule chooses it from what the island is (stages/prepare_islands.h); manifolds lie
// in stores per effort, so all that hangs together by manifolds or joints has the same one.
#pragma once

#include <array>
#include <cstdint>

#include "jostle/physics/defs.h"

namespace jostle::physics {

// In rising order.
enum class Effort : std::uint8_t {
    flat,     // at most three layers, all slow
    low,      // what nothing is known of yet or moves: contacts learn the force of each point
    heap,     // most of it lies still, on more ground than it is high: like low, but stiffer; with
              // sleep, more sub-steps
    slender,  // stacks and walls: contacts learn the force of a manifold; moments would make it
              // sway
    tall,     // many layers of that, which at the same sub-steps lean and in the end fall
    heavy,    // a body rests on nothing but what is a hundred times lighter
    frozen,   // none: of manifolds, not of islands. Nobody of it moves (state/frozen.h)
};
inline constexpr int effort_count = 6;
inline constexpr std::array<Effort, effort_count> all_efforts = {
    Effort::flat, Effort::low, Effort::heap, Effort::slender, Effort::tall, Effort::heavy};
inline constexpr std::size_t index_of(Effort effort) {
    return static_cast<std::size_t>(effort);
}

// The islands of an effort lie in so many batches, whole: threads solve batches side by side, each
// alone, without waiting for one another. In a larger one they share the colours.
inline constexpr int batch_count = 4;

// Which store of manifolds: one per effort and batch, and one for what is frozen.
struct StoreKey {
    Effort effort = Effort::low;
    std::uint8_t batch = 0;
    bool operator==(const StoreKey&) const = default;
};
inline constexpr int solved_store_count = effort_count * batch_count;
inline constexpr int store_count = solved_store_count + 1;

inline constexpr std::size_t index_of(StoreKey key) {
    return index_of(key.effort) * batch_count + key.batch;
}
inline constexpr StoreKey frozen_store = {Effort::frozen, 0};
static_assert(index_of(frozen_store) == store_count - 1);

// Sub-steps of an island. More of them keep a heap from slipping now and then: where bodies may
// sleep, what then rests saves more than they cost.
inline int substeps_of(Effort effort, const WorldDef& world) {
    constexpr std::array<int, effort_count> halves = {1, 2, 2, 2, 4, 8};
    const int most = effort == Effort::heap && world.sleeping ? 3 : halves[index_of(effort)];
    return (world.substeps * most + 1) / 2;
}

// Those between which an island does not change for its neighbours' sake.
inline bool is_usual(Effort effort) {
    return Effort::low <= effort && effort <= Effort::slender;
}

}  // namespace jostle::physics
