// SPDX-License-Identifier: MIT
//
// Scratch data that update_sleep and put_parts_to_sleep reuse from step to step. No later stage
// reads it.
#pragma once

#include <cstdint>
#include <vector>

namespace jostle::physics {

struct SleepScratch {
    std::vector<std::uint32_t> islands;  // awake islands, in ascending order
    // Indexed by island; valid for the awake ones: shortest and longest rest time of its bodies, s.
    std::vector<double> shortest, longest;
    std::vector<std::uint8_t> restless;  // by hot index: has not rested for long
    // By hot index: restless, touches a restless body, or is jointed to such a body.
    std::vector<std::uint8_t> near_restless;
    std::vector<std::uint32_t>
        resting;  // by island: number of bodies that could sleep in place, or do
    std::vector<std::uint32_t> falling_asleep;  // body indices
};

}  // namespace jostle::physics
