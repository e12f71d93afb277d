// SPDX-License-Identifier: MIT
//
// How hard the solver works on an island: its sub-steps per step and its sweeps over the points of
// a manifold. A rule chooses it from what the island is (stages/prepare_islands.h); manifolds lie
// in a store per effort, so all that hangs together by manifolds or joints has the same one.
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
// One store of manifolds for each, and one for what is frozen.
inline constexpr int store_count = effort_count + 1;

inline constexpr std::size_t index_of(Effort effort) {
    return static_cast<std::size_t>(effort);
}

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
