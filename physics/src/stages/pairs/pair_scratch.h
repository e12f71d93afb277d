// SPDX-License-Identifier: MIT
//
// Scratch data that update_pairs and update_triggers reuse from step to step.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace jostle::physics {

// Results of one grain of update_pairs, a range of the moved shapes.
struct NewPairs {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // shapes
    std::vector<std::uint32_t> near;                             // shapes, of one query
};

struct PairScratch {
    std::vector<NewPairs> new_pairs;        // by grain; the first one finally holds all pairs
    std::vector<std::uint32_t> in_trigger;  // shapes, of one query of update_triggers
};

}  // namespace jostle::physics
