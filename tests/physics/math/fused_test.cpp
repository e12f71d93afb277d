// SPDX-License-Identifier: MIT
//
// Multiplying and adding in doubles gives what the processor's one instruction gives.
#include "physics/src/math/fused.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

float from_bits(std::uint32_t bits) {
    float f;
    std::memcpy(&f, &bits, sizeof f);
    return f;
}
bool same(float a, float b) {
    return std::isnan(a) ? std::isnan(b) : std::memcmp(&a, &b, sizeof a) == 0;
}

TEST(Fused, two_million_random_floats_round_once) {
    Random random(5);
    for (int k = 0; k < 2000000; k++) {
        const auto any = [&] {
            return from_bits(static_cast<std::uint32_t>(random.below(0x10000)) << 16 |
                             static_cast<std::uint32_t>(random.below(0x10000)));
        };
        const float a = any(), b = any(), c = any();
        ASSERT_TRUE(same(multiply_add_in_double(a, b, c), std::fma(a, b, c)))
            << a << " * " << b << " + " << c;
    }
}

// Products of 25 digits lie half-way between two floats, and the addend is too small for a double
// to see it: the double nearest to the sum is half-way, the sum itself is not.
TEST(Fused, a_million_near_ties_round_correctly) {
    Random random(6);
    int rounded_twice = 0;
    for (int k = 0; k < 1000000; k++) {
        const auto few = [&](int digits) {
            return std::ldexp(
                1.0f + static_cast<float>(random.below(1 << digits)) * std::ldexp(1.0f, -digits),
                static_cast<int>(random.below(3)) - 1);
        };
        const float a = few(12), b = few(12);
        const float c = std::ldexp(random.below(2) == 0 ? 1.0f : -1.0f, -60);
        const float right = std::fma(a, b, c);
        ASSERT_TRUE(same(multiply_add_in_double(a, b, c), right)) << a << " * " << b << " + " << c;
        if (!same(static_cast<float>(double{a} * double{b} + double{c}), right)) rounded_twice++;
    }
    EXPECT_GT(rounded_twice, 0);  // the cases do what they are for
}

}  // namespace
}  // namespace jostle::test
