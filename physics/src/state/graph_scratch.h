// SPDX-License-Identifier: MIT
//
// Scratch memory for traversals of connected bodies, reused between traversals. Not part of the
// state.
#pragma once

#include <cstdint>
#include <vector>

namespace jostle::physics {

struct GraphScratch {
    std::vector<std::uint8_t> visited, seen_jointed;  // by body; zero between uses
    std::vector<std::uint8_t> visited_jointed;        // by body
    std::vector<std::uint32_t> jointed;               // bodies
    std::vector<std::uint32_t> stack;
};

}  // namespace jostle::physics
