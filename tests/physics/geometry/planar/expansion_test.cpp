// SPDX-License-Identifier: MIT
//
// Sums without error against integers of 128 bits.
#include "physics/src/geometry/planar/expansion.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics::planar;

__extension__ typedef __int128 Wide;

// Whole, of up to `bits` bits, as often small as large.
double whole(Random& random, std::uint64_t bits) {
    const auto size = static_cast<double>(random.bits() >> (64 - 1 - random.below(bits)));
    return random.below(2) == 0 ? size : -size;
}

TEST(Expansion, rounded_sum_plus_error_is_exact) {
    Random random(1);
    for (int k = 0; k < 20000; k++) {
        const double a = whole(random, 53), b = whole(random, 30) * 0x1p40;
        const Rounded sum = two_sum(a, b), less = two_difference(a, b);
        ASSERT_EQ(sum.value, a + b);
        ASSERT_TRUE(Wide(sum.value) + Wide(sum.error) == Wide(a) + Wide(b));
        ASSERT_TRUE(Wide(less.value) + Wide(less.error) == Wide(a) - Wide(b));
    }
}

TEST(Expansion, rounded_product_plus_error_is_exact) {
    Random random(2);
    for (int k = 0; k < 20000; k++) {
        const double a = whole(random, 53), b = whole(random, 53);
        const Rounded product = two_product(a, b);
        ASSERT_EQ(product.value, a * b);
        ASSERT_TRUE(Wide(product.value) + Wide(product.error) == Wide(a) * Wide(b));
    }
}

// Sixteen numbers of very different size that nearly cancel: the sign and the value are those of
// the exact sum.
TEST(Expansion, sum_of_sixteen_numbers_has_exact_sign_and_value) {
    Random random(3);
    for (int k = 0; k < 20000; k++) {
        Expansion<16> expansion;
        Wide sum = 0;
        const auto add = [&](double x) {
            expansion.add(x);
            sum += Wide(x);
        };
        for (int j = 0; j < 7; j++) add(whole(random, 50) * (j % 2 == 0 ? 0x1p60 : 1));
        for (int j = 0; j < 7; j++) {
            const double rest = static_cast<double>(sum);  // the sum so far, nearly
            add(j % 2 == 0 ? -rest : whole(random, 20));
        }
        const double value = expansion.value(), exact = static_cast<double>(sum);
        ASSERT_EQ(value > 0, sum > 0);
        ASSERT_EQ(value < 0, sum < 0);
        ASSERT_LE(physics::absolute(value - exact), 1e-15 * physics::absolute(exact));
    }
}

TEST(Expansion, cancelling_numbers_sum_to_zero) {
    Expansion<4> expansion;
    EXPECT_EQ(expansion.value(), 0);
    for (const double x : {1e16, 1.0, -1e16}) expansion.add(x);
    EXPECT_EQ(expansion.value(), 1);
    expansion.add(Rounded{-1, 0});
    EXPECT_EQ(expansion.value(), 0);
}

}  // namespace
}  // namespace jostle::test
