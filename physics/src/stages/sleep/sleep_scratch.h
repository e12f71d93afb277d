// SPDX-License-Identifier: MIT
//
// What update_sleep and put_parts_to_sleep use again from step to step. Nothing in it is for a
// later stage.
#pragma once

#include <cstdint>
#include <vector>

namespace jostle::physics {

struct SleepScratch {
    std::vector<std::uint32_t> islands;  // that are awake, rising
    // By island, of these: the time at rest of its most restless and of its most restful body, s.
    std::vector<double> shortest, longest;
    std::vector<std::uint8_t> restless;  // by hot index: has not rested for long
    // By hot index: restless, touches one that is, or is jointed to one of either.
    std::vector<std::uint8_t> near_restless;
    std::vector<std::uint32_t> resting;  // by island: bodies that could sleep in place, or do
    std::vector<std::uint32_t> falling_asleep;  // bodies
};

}  // namespace jostle::physics
