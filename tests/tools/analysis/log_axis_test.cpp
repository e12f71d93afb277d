// SPDX-License-Identifier: MIT
#include "jostle/analysis/log_axis.h"

#include <gtest/gtest.h>

namespace jostle::plots {
namespace {

TEST(LogAxis, runs_from_decade_to_decade) {
    const LogAxis axis = log_axis_over({0.3, 20, 0}, 100, 400);
    EXPECT_EQ(axis.low, -1);
    EXPECT_EQ(axis.high, 2);
    EXPECT_DOUBLE_EQ(axis.at(1), 200);
    EXPECT_DOUBLE_EQ(axis.at(0), 100);
    EXPECT_DOUBLE_EQ(axis.at(1e9), 400);
}

TEST(LogAxis, numbers_are_short) {
    EXPECT_EQ(short_number(0.001), "0.001");
    EXPECT_EQ(short_number(0.1234), "0.12");
    EXPECT_EQ(short_number(123.4), "123");
    EXPECT_EQ(short_number(50000), "50000");
}

}  // namespace
}  // namespace jostle::plots
