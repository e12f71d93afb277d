// SPDX-License-Identifier: MIT
//
// What update_sleep uses again from step to step.
#pragma once

#include <cstdint>
#include <vector>

namespace jostle::physics {

struct SleepScratch {
    // By island: the time at rest of its most restless and of its most restful body, s.
    std::vector<double> shortest, longest;
    // By hot index: moves; or touches one that does, or is jointed to one of either.
    std::vector<std::uint8_t> restless, beside;
    std::vector<std::uint32_t> resting;  // by island: bodies that could sleep in place, or do
    std::vector<std::uint32_t> falling_asleep;  // bodies
};

}  // namespace jostle::physics
