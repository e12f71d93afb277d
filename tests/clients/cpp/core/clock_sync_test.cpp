// SPDX-License-Identifier: MIT
#include "jostle/client/clock_sync.h"

#include <gtest/gtest.h>

namespace jostle::client {

TEST(ClockSync, uses_the_sample_with_the_shortest_round_trip) {
    ClockSync clock;
    EXPECT_FALSE(clock.ready());
    clock.add(0, 1'050'000, 100'000);        // 100 ms round trip; the true offset is 1 s
    clock.add(200'000, 1'281'000, 280'000);  // asymmetric: offset 1.041 s
    clock.add(300'000, 1'301'000, 302'000);
    EXPECT_EQ(clock.offset_us(), 1'000'000);
    EXPECT_DOUBLE_EQ(clock.rtt_ms(), 2);
}

TEST(ClockSync, discards_samples_older_than_thirty_seconds) {
    ClockSync clock;
    clock.add(0, 1'000'500, 1'000);
    clock.add(40'000'000, 40'900'000 + 5'000, 40'010'000);
    EXPECT_EQ(clock.offset_us(), 900'000);
}

TEST(ClockSync, rejects_out_of_range_times) {
    ClockSync clock;
    clock.add(0, 0x7fffffffffffffff, 1'000);
    clock.add(0, 0xffffffffffffffff, 1'000);
    EXPECT_FALSE(clock.ready());
    clock.add(0, latest_time_us, 1'000);
    EXPECT_EQ(clock.server_us(Clock::time_point(std::chrono::microseconds(500))),
              static_cast<std::int64_t>(latest_time_us));
}

TEST(ClockSync, rejects_pongs_from_the_future) {
    ClockSync clock;
    clock.add(500, 1, 400);
    EXPECT_FALSE(clock.ready());
}

}  // namespace jostle::client
