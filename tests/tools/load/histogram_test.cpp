// SPDX-License-Identifier: MIT
#include "tools/load/histogram.h"

#include <gtest/gtest.h>

namespace jostle::load {

TEST(Histogram, returns_percentiles_within_three_percent) {
    Histogram histogram;
    for (std::int64_t us = 1; us <= 100'000; us++) histogram.add(us);
    const Percentiles p = percentiles_of(histogram);
    EXPECT_EQ(p.count, 100'000u);
    EXPECT_NEAR(p.p50, 50, 1.5);
    EXPECT_NEAR(p.p90, 90, 2.7);
    EXPECT_NEAR(p.p99, 99, 3);
    EXPECT_NEAR(p.p99_9, 99.9, 3);
    EXPECT_EQ(p.max, 100);
}

TEST(Histogram, stores_small_durations_exactly_and_clamps_extreme_ones) {
    Histogram histogram;
    for (const std::int64_t us : {-5, 0, 7, 7, 7, 63}) histogram.add(us);
    EXPECT_EQ(histogram.percentile(0), 0);
    EXPECT_EQ(histogram.percentile(60), 7);
    EXPECT_EQ(histogram.max(), 63);
    histogram.add(INT64_MAX);
    EXPECT_EQ(histogram.max(), (std::int64_t{1} << 37) - 1);  // 38 hours
    EXPECT_EQ(Histogram().percentile(99), 0);
}

TEST(Histogram, merges_histograms_of_two_threads) {
    Histogram a, b;
    for (int k = 0; k < 900; k++) a.add(10);
    for (int k = 0; k < 100; k++) b.add(40);
    a.merge(b);
    EXPECT_EQ(a.count(), 1000u);
    EXPECT_EQ(a.percentile(89), 10);
    EXPECT_EQ(a.percentile(91), 40);
    EXPECT_EQ(a.max(), 40);
}

}  // namespace jostle::load
