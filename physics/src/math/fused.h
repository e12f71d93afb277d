// SPDX-License-Identifier: MIT
//
// Multiply-add of floats with a single rounding, also on processors without such an instruction. In
// a portable build (jostle/physics/arithmetic.h) it is a product and a sum, each rounded.
#pragma once

#include <bit>
#include <cstdint>

namespace jostle::physics {

// The product of two floats is exact in a double. The sum is not; rounded to odd, it still
// determines the correct rounding to float (Boldo and Melquiond, "Emulation of FMA and correctly
// rounded sums: proved algorithms using rounding to odd", IEEE Trans. Computers 57, 2008).
inline float multiply_add_in_double(float a, float b, float c) {
    const double product = double{a} * double{b}, addend = double{c};
    const double sum = product + addend;
    // The exact rounding error of the sum (Knuth's TwoSum).
    const double part = sum - product;
    const double lost = (product - (sum - part)) + (addend - part);
    auto bits = std::bit_cast<std::uint64_t>(sum);
    if ((lost < 0 || lost > 0) && (bits & 1) == 0)
        bits = (lost > 0) == (sum > 0) ? bits + 1 : bits - 1;
    return static_cast<float>(std::bit_cast<double>(bits));
}

inline __attribute__((always_inline)) float fused_multiply_add(float a, float b, float c) {
#if defined(JOSTLE_UNFUSED)
    return a * b + c;  // not fused because of -ffp-contract=off
#elif defined(__FMA__) || defined(__aarch64__)
    return __builtin_fmaf(a, b, c);
#else
    return multiply_add_in_double(a, b, c);
#endif
}

}  // namespace jostle::physics
