// SPDX-License-Identifier: MIT
//
// Corrupted words, for tests of untrusted input.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tests/support/random.h"

namespace jostle::test {

// Flips a few bits, and truncates every third list.
inline std::vector<std::uint32_t> corrupted(std::span<const std::uint32_t> good, Random& random) {
    std::vector<std::uint32_t> words(good.begin(), good.end());
    if (random.below(3) == 0) words.resize(random.below(words.size()));
    for (int flips = 0; flips < 4 && !words.empty(); flips++)
        words[random.below(words.size())] ^= 1u << random.below(32);
    return words;
}

}  // namespace jostle::test
