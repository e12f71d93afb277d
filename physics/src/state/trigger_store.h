// SPDX-License-Identifier: MIT
//
// What is inside which trigger, as of the last step.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

namespace jostle::physics {

struct Inside {
    std::uint32_t trigger = 0, shape = 0;

    auto operator<=>(const Inside&) const = default;
};

struct TriggerStore {
    std::vector<Inside> inside;        // rising
    std::vector<std::uint32_t> fresh;  // triggers that are new or were moved: to be checked into
                                       // even where nothing moves
};

}  // namespace jostle::physics
