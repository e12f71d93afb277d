// SPDX-License-Identifier: MIT
//
// Numbers that code is more likely to stumble over than any others.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace jostle::fuzz {

using Random = std::minstd_rand;

inline std::uint32_t below(Random& random, std::uint32_t n) {
    return n == 0 ? 0 : static_cast<std::uint32_t>(random()) % n;
}
inline std::uint64_t any_bits(Random& random) {
    std::uint64_t bits = 0;
    for (int k = 0; k < 4; k++) bits = bits << 16 ^ (static_cast<std::uint64_t>(random()) >> 4);
    return bits;
}

// Another number in place of x: a limit, a neighbour, a multiple, or anything.
inline double mutated_number(double x, Random& random) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    static constexpr double known[] = {0,
                                       -0.0,
                                       1,
                                       -1,
                                       0.5,
                                       -9.81,
                                       2,
                                       10,
                                       0.05,
                                       1e-3,
                                       1e-6,
                                       1e-9,
                                       1e-15,
                                       1e-30,
                                       1e-150,
                                       1e-300,
                                       100,
                                       1e3,
                                       1e4,
                                       1e6,
                                       1e7,
                                       1e9,
                                       1e12,
                                       1e15,
                                       1e20,
                                       1e38,
                                       1e39,
                                       -1e7,
                                       -1e30,
                                       3.14159,
                                       1e155,
                                       std::numeric_limits<double>::max(),
                                       inf,
                                       -inf,
                                       std::numeric_limits<double>::quiet_NaN(),
                                       std::numeric_limits<double>::denorm_min()};
    switch (below(random, 8)) {
        case 0:
        case 1:
        case 2:
            return known[below(random, std::size(known))];
        case 3:
            return -x;
        case 4:
            return x * std::ldexp(1.0, static_cast<int>(below(random, 20)) - 10);
        case 5:
            return x + static_cast<double>(below(random, 2001)) / 1000 - 1;
        case 6:
            return std::nextafter(x, below(random, 2) == 0 ? inf : -inf);
        default:
            return std::bit_cast<double>(any_bits(random));
    }
}

inline std::uint64_t mutated_integer(std::uint64_t x, Random& random) {
    switch (below(random, 6)) {
        case 0:
            return below(random, 8);
        case 1:
            return x + 1;
        case 2:
            return x - 1;
        case 3:
            return std::uint64_t{1} << below(random, 64);
        case 4:
            return (std::uint64_t{1} << below(random, 64)) - 1;
        default:
            return any_bits(random);
    }
}

}  // namespace jostle::fuzz
