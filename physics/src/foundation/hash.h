// SPDX-License-Identifier: MIT
//
// A 64-bit hash of a sequence of 64-bit words, identical on every machine. Not resistant to hostile
// keys: it verifies equality of states and detects accidental corruption of saved bytes.
#pragma once

#include <cstdint>

namespace jostle::physics {

struct Hasher {
    std::uint64_t value = 0x9e3779b97f4a7c15ull;

    // One multiply-xorshift round per word (the finaliser of MurmurHash3 by Appleby).
    void add(std::uint64_t word) {
        std::uint64_t h = value ^ word;
        h ^= h >> 33;
        h *= 0xff51afd7ed558ccdull;
        h ^= h >> 33;
        h *= 0xc4ceb9fe1a85ec53ull;
        h ^= h >> 33;
        value = h + 0x9e3779b97f4a7c15ull;
    }
};

}  // namespace jostle::physics
