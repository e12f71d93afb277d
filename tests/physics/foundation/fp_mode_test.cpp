// SPDX-License-Identifier: MIT
//
// Inside the scope floats are rounded to nearest and denormal ones are zero (kept in a portable
// build), whatever the host program asked for; outside it is as before.
#include "physics/src/foundation/fp_mode.h"

#include <gtest/gtest.h>

#include <cfenv>

namespace jostle::test {
namespace {

// At run time: the compiler would use the mode that it was compiled with.
float quotient(float a, float b) {
    volatile float x = a, y = b;
    return x / y;
}

TEST(FpMode, rounds_to_nearest_and_restores_the_host_mode) {
    const float down = [] {
        std::fesetround(FE_DOWNWARD);
        return quotient(2, 3);
    }();
    float inside = 0;
    {
        const physics::FpModeScope scope;
        inside = quotient(2, 3);
    }
    EXPECT_EQ(std::fegetround(), FE_DOWNWARD);
    const float after = quotient(2, 3);
    std::fesetround(FE_TONEAREST);
    const float nearest = quotient(2, 3);
    EXPECT_LT(down, nearest) << "two thirds round up";
    EXPECT_EQ(inside, nearest);
    EXPECT_EQ(after, down);
}

TEST(FpMode, flushes_denormals_only_inside_the_scope) {
    const float smallest = 1.17549435e-38f;  // of the normal ones
    EXPECT_GT(quotient(smallest, 2), 0);
    {
        const physics::FpModeScope scope;
        const float half = quotient(smallest, 2);
        if (physics::flushes_denormals)
            EXPECT_EQ(half, 0);
        else
            EXPECT_GT(half, 0);
    }
    EXPECT_GT(quotient(smallest, 2), 0);
}

}  // namespace
}  // namespace jostle::test
