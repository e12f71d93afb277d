// SPDX-License-Identifier: MIT
#include "server/limits/cadence.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(Cadence, classes_are_divisors_of_the_tick_rate) {
    const Cadence cadence(60, 1);
    for (int number = 0; number <= cadence.slowest(); number++)
        EXPECT_EQ(60 % cadence.step(number), 0u) << number;
    EXPECT_EQ(cadence.rate(0), 60);
    EXPECT_EQ(cadence.rate(1), 30);
    EXPECT_EQ(cadence.rate(2), 20);
    EXPECT_EQ(cadence.rate(cadence.slowest()), 1);
}

TEST(Cadence, classes_are_relative_to_the_requested_rate) {
    const Cadence cadence(60, 3);
    EXPECT_EQ(cadence.rate(0), 20);
    EXPECT_EQ(cadence.step(1), 6u);
    EXPECT_GE(cadence.rate(cadence.slowest()), 1);
    EXPECT_TRUE(cadence.is_requested(9));
    EXPECT_FALSE(cadence.is_requested(10));
}

TEST(Cadence, finds_the_fastest_class_within_a_rate) {
    const Cadence cadence(60, 1);
    EXPECT_EQ(cadence.rate(cadence.class_within(100)), 60);
    EXPECT_EQ(cadence.rate(cadence.class_within(59)), 30);
    EXPECT_EQ(cadence.rate(cadence.class_within(13)), 12);
    EXPECT_EQ(cadence.rate(cadence.class_within(0.1)), 1);
}

TEST(Cadence, slow_worlds_have_fewer_classes) {
    EXPECT_EQ(Cadence(10, 1).rate(Cadence(10, 1).slowest()), 1);
    EXPECT_EQ(Cadence(0.5, 1).slowest(), 0);
    EXPECT_EQ(Cadence(240, 1).rate(Cadence(240, 1).slowest()), 1);
}

TEST(Cadence, changes_are_aligned_five_times_per_second) {
    const Cadence cadence(60, 1);
    int aligned = 0;
    for (std::uint32_t tick = 1; tick <= 60; tick++) aligned += cadence.is_aligned(tick) ? 1 : 0;
    EXPECT_EQ(aligned, 5);
}

}  // namespace
}  // namespace jostle::server
