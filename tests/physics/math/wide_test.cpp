// SPDX-License-Identifier: MIT
//
// Eight lanes on this machine's registers against one float at a time, rounded as this build does
// (jostle/physics/arithmetic.h).
#define JOSTLE_ISA wide_for_tests
#include "physics/src/math/wide.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "jostle/physics/arithmetic.h"
#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics::wide_for_tests;

struct alignas(32) Floats {
    float at[8];
};
Floats floats_of(Wide w) {
    Floats f;
    store(f.at, w);
    return f;
}
Wide random_wide(Random& random) {
    Floats f;
    for (float& x : f.at) x = static_cast<float>(random.in(-3, 3));
    return load(f.at);
}
// The same bits, so that -0 and 0 are two numbers.
void expect_lanes(Wide w, const Floats& expected) {
    const Floats f = floats_of(w);
    for (int k = 0; k < 8; k++)
        ASSERT_EQ(std::bit_cast<std::uint32_t>(f.at[k]),
                  std::bit_cast<std::uint32_t>(expected.at[k]))
            << "lane " << k;
}
template <class Lane>
Floats each(Lane&& lane) {
    Floats f;
    for (int k = 0; k < 8; k++) f.at[k] = lane(k);
    return f;
}

float multiply_add(float a, float b, float c) {
    return physics::arithmetic() == physics::Arithmetic::fused ? std::fma(a, b, c) : a * b + c;
}

TEST(Wide, lanes_are_independent) {
    Random random(201);
    for (int round = 0; round < 1000; round++) {
        const Wide a = random_wide(random), b = random_wide(random), c = random_wide(random);
        expect_lanes(fma(a, b, c), each([&](int k) { return multiply_add(a[k], b[k], c[k]); }));
        expect_lanes(fnma(a, b, c), each([&](int k) { return multiply_add(-a[k], b[k], c[k]); }));
        expect_lanes(min(a, b), each([&](int k) { return a[k] < b[k] ? a[k] : b[k]; }));
        expect_lanes(max(a, b), each([&](int k) { return a[k] > b[k] ? a[k] : b[k]; }));
        expect_lanes(select(a > b, b, c), each([&](int k) { return a[k] > b[k] ? b[k] : c[k]; }));
        expect_lanes(root(absolute(a)), each([&](int k) { return std::sqrt(std::fabs(a[k])); }));
        unsigned bits = 0;
        for (int k = 0; k < 8; k++) bits |= (a[k] < b[k] ? 1u : 0u) << k;
        ASSERT_EQ(lane_bits(a < b), bits);
    }
}

// Of two zeros and with what is no number the second one is taken, as x86 does: minps and its like
// on other machines disagree.
TEST(Wide, min_and_max_of_signed_zeros_and_nan_return_the_second_operand) {
    const float none = std::numeric_limits<float>::quiet_NaN();
    for (const auto& [x, y] : {std::pair{0.0f, -0.0f}, {-0.0f, 0.0f}, {none, 1.0f}, {1.0f, none}}) {
        expect_lanes(min(splat(x), splat(y)), floats_of(splat(y)));
        expect_lanes(max(splat(x), splat(y)), floats_of(splat(y)));
    }
}

// Eight rows of eight floats come back as they were; in between float k of all is in register k.
TEST(Wide, transposes_rows_and_back) {
    Floats rows[8], back[8];
    const float* from[8];
    float* to[8];
    for (int row = 0; row < 8; row++) {
        for (int k = 0; k < 8; k++) rows[row].at[k] = static_cast<float>(10 * row + k);
        from[row] = rows[row].at;
        to[row] = back[row].at;
    }
    Wide turned[8];
    load_rows(from, 0, turned);
    for (int k = 0; k < 8; k++)
        expect_lanes(turned[k], each([&](int row) { return static_cast<float>(10 * row + k); }));
    store_rows(to, turned);
    for (int row = 0; row < 8; row++)
        for (int k = 0; k < 8; k++) EXPECT_EQ(back[row].at[k], rows[row].at[k]);
}

TEST(Wide, cross_products_are_perpendicular_to_both_vectors) {
    Random random(202);
    const auto vector = [&] {
        return Wide3{random_wide(random), random_wide(random), random_wide(random)};
    };
    for (int round = 0; round < 100; round++) {
        const Wide3 a = vector(), b = vector(), n = cross(a, b);
        for (int k = 0; k < 8; k++) {
            EXPECT_NEAR(dot(n, a)[k], 0, 2e-5f);
            EXPECT_NEAR(dot(n, b)[k], 0, 2e-5f);
        }
    }
}

}  // namespace
}  // namespace jostle::test
