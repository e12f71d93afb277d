// SPDX-License-Identifier: MIT
#include "bench/speed/growth.h"

#include <gtest/gtest.h>

namespace {

using namespace jostle::bench;

TEST(Growth, small_pile_reports_time_and_bytes_per_body) {
    const GrowthRow row = measure_growth_in_child(*find_engine_kind("jostle"), 1, 40);
    ASSERT_FALSE(row.failed) << *row.failed;
    EXPECT_EQ(row.bodies, 40);
    EXPECT_EQ(row.clock, "cpu");
    EXPECT_GT(row.ms_mean, 0);
    EXPECT_GT(row.bytes_per_body, 100);
    EXPECT_EQ(to_json(growth_row_from(to_json(row))), to_json(row));
}

}  // namespace
