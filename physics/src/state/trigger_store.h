// SPDX-License-Identifier: MIT
//
// Shapes inside triggers, as of the last step.
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
    std::vector<Inside> inside;  // ascending
    // New or moved triggers, which are tested even if nothing moves.
    std::vector<std::uint32_t> fresh;
};

}  // namespace jostle::physics
