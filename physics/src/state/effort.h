// SPDX-License-Identifier: MIT
//
// How hard the solver works on an island: its sub-steps per step and its sweeps over the points of
// a manifold. A rule chooses it from what the island is (stages/prepare_islands.h); manifolds lie
// in a store per effort, so all that hangs together by manifolds or joints has the same one.
#pragma once

#include <array>
#include <cstdint>

namespace jostle::physics {

// In rising order.
enum class Effort : std::uint8_t {
    standard,
    tall,   // many layers upon each other, which at the standard effort lean and in the end fall
    heavy,  // something a hundred times heavier lies on something
};
inline constexpr int effort_count = 3;
inline constexpr std::array<Effort, effort_count> all_efforts = {Effort::standard, Effort::tall,
                                                                 Effort::heavy};

inline constexpr std::size_t index_of(Effort effort) {
    return static_cast<std::size_t>(effort);
}

// Sub-steps of an island in a world of so many.
inline constexpr int substeps_of(Effort effort, int world_substeps) {
    return world_substeps << index_of(effort);
}

}  // namespace jostle::physics
