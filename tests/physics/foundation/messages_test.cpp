// SPDX-License-Identifier: MIT
//
// Numbers in messages: nine digits, no noise behind them.
#include "physics/src/foundation/messages.h"

#include <gtest/gtest.h>

#include <limits>

namespace jostle::test {
namespace {
using namespace physics;

TEST(Messages, numbers_have_at_most_nine_digits) {
    EXPECT_EQ(text(0.001), "0.001");
    EXPECT_EQ(text(10000), "10000");
    EXPECT_EQ(text(1.0 / 3), "0.333333333");
    EXPECT_EQ(text(-1e300), "-1e+300");
    EXPECT_EQ(text(-std::numeric_limits<double>::max()), "-1.79769313e+308");
    EXPECT_EQ(text(std::numeric_limits<double>::infinity()), "inf");
}

}  // namespace
}  // namespace jostle::test
