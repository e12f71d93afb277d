// SPDX-License-Identifier: MIT
//
// What update_pairs and update_triggers use again from step to step.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace jostle::physics {

// What one grain of update_pairs found, which is some of the shapes that moved.
struct NewPairs {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // shapes
    std::vector<std::uint32_t> near;                             // shapes, of one query
};

struct PairScratch {
    std::vector<NewPairs> new_pairs;        // by grain; the first ends up with those of all
    std::vector<std::uint32_t> in_trigger;  // shapes, of one query of update_triggers
};

}  // namespace jostle::physics
