// SPDX-License-Identifier: MIT
//
// exp of what is not positive, without the C library: the same bits everywhere.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace jostle::modules::fields_detail {

// Error below 1e-15 of the value for x from -700 to 0; 0 below that. Reduction by ln 2 in two
// parts, then the Taylor polynomial on [-ln2/2, ln2/2] (Muller, "Elementary Functions", chapter
// 11).
inline double exp_of_negative(double x) {
    if (!(x > -700)) return 0;
    const double whole = std::floor(x * 1.44269504088896340736 + 0.5);
    constexpr double high = 6.93147180369123816490e-01, low = 1.90821492927058770002e-10;
    const double r = (x - whole * high) - whole * low;
    double sum = 1;
    for (int k = 13; k >= 1; k--) sum = 1 + sum * r / k;
    const auto exponent = static_cast<std::uint64_t>(static_cast<std::int64_t>(whole) + 1023);
    return sum * std::bit_cast<double>(exponent << 52);
}

}  // namespace jostle::modules::fields_detail
