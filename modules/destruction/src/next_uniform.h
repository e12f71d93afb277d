// SPDX-License-Identifier: MIT
//
// Deterministic random numbers: SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, 2014).
#pragma once

#include <cstdint>

namespace jostle::modules::destruction_detail {

// Uniform in [0, 1).
inline double next_uniform(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

}  // namespace jostle::modules::destruction_detail
