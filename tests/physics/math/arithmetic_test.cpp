// SPDX-License-Identifier: MIT
//
// What a build says of its rounding is what its solver does.
#include "jostle/physics/arithmetic.h"

#include <gtest/gtest.h>

#include "physics/src/foundation/fp_mode.h"
#include "physics/src/math/fused.h"

namespace jostle::test {
namespace {
using namespace physics;

// (1 + 2^-23)^2 - (1 + 2^-22) is 2^-46, which is lost where the square is rounded first.
TEST(Arithmetic, is_fused_if_the_residual_of_a_square_is_exact) {
    volatile float a = 1 + 0x1p-23f, c = -(1 + 0x1p-22f);
    const float left = fused_multiply_add(a, a, c);
    if (arithmetic() == Arithmetic::fused)
        EXPECT_EQ(left, 0x1p-46f);
    else
        EXPECT_EQ(left, 0);
    EXPECT_EQ(flushes_denormals, arithmetic() == Arithmetic::fused);
}

TEST(Arithmetic, has_a_name_for_reports) {
    EXPECT_STREQ(arithmetic_name(Arithmetic::fused), "fused");
    EXPECT_STREQ(arithmetic_name(Arithmetic::portable), "portable");
}

}  // namespace
}  // namespace jostle::test
