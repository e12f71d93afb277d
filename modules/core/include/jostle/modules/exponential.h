// SPDX-License-Identifier: MIT
//
// Exponential function for modules, with the same bits on all machines.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace jostle::modules {

/// Returns exp(x) of a non-positive number without the C library. The relative error is below 1e-11
/// for x from -700 to 0; returns 0 below.
///
/// Range reduction by ln 2, then the Taylor polynomial on [-ln2/2, ln2/2] (J.-M. Muller,
/// "Elementary Functions", chapter 11).
inline double exp_of_negative(double x) {
    if (!(x > -700)) return 0;
    const double multiple = std::floor(x * 1.44269504088896340736 + 0.5);
    const double r = x - multiple * 0.693147180559945309417, r2 = r * r;
    // Even and odd powers are summed separately: two short dependency chains instead of a long one.
    const double even =
        1 + r2 * (1.0 / 2 + r2 * (1.0 / 24 + r2 * (1.0 / 720 + r2 * (1.0 / 40320))));
    const double odd =
        1 + r2 * (1.0 / 6 + r2 * (1.0 / 120 + r2 * (1.0 / 5040 + r2 * (1.0 / 362880))));
    const double sum = even + r * odd;
    const auto biased = static_cast<std::uint64_t>(static_cast<std::int64_t>(multiple) + 1023);
    return sum * std::bit_cast<double>(biased << 52);
}

}  // namespace jostle::modules
