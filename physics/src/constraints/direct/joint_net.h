// SPDX-License-Identifier: MIT
//
// Estimates of the matrix of a group of joints from the number of its joints and bodies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "jostle/physics/block_ldl.h"

namespace jostle::physics {

inline std::size_t as_index(int i) {
    return static_cast<std::size_t>(i);
}

// Returns whether so many joints connect so few bodies that their matrix is dense, as for a cloth,
// and nearly singular as soon as the cloth bends. Needs no pattern analysis. A few joints on one
// body (a door on three hinges) do not count.
inline bool is_net(int joints, int bodies) {
    return joints > 8 && 2 * joints > 3 * bodies;
}

// Returns whether so many joints connect so few bodies that many rows are redundant.
inline bool is_redundant(int joints, int bodies) {
    return 4 * joints > 5 * bodies;
}

// Minimum work of a factorisation in which `nodes` nodes of `rows` rows each are all coupled, as
// the joints of one body are. Needs no edge list, whose length is quadratic.
inline std::int64_t clique_work(std::size_t nodes, int rows) {
    if (nodes > 1'000'000) return std::numeric_limits<std::int64_t>::max();
    const auto n = static_cast<std::int64_t>(nodes), m = std::int64_t{rows};
    return m * m * m * (n + (n - 1) * n * (n + 1) / 6);
}

}  // namespace jostle::physics
