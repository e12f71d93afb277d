// SPDX-License-Identifier: MIT
#include "jostle/client/render_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace jostle::client {
namespace {

// Frames at 60 Hz, each with a transit time, and a rendered frame after each.
struct Feed {
    RenderClock clock;
    std::int64_t due_us = 50'000'000, ours_us = 1'000;  // two different clocks
    double least = 1, greatest = 1;

    void frames(int count, std::int64_t way_us) {
        for (int k = 0; k < count; k++) {
            due_us += 16'667;
            ours_us += 16'667;
            clock.on_frame(due_us, ours_us + way_us);
            clock.advance(ours_us + way_us);
            least = std::min(least, clock.speed());
            greatest = std::max(greatest, clock.speed());
        }
    }
    double behind_ms(std::int64_t way_us) const {
        return static_cast<double>(due_us + way_us - clock.render_time_us()) / 1000;
    }
};

}  // namespace

TEST(RenderClock, renders_latency_plus_1_7_intervals_behind_for_regular_frames) {
    Feed feed;
    feed.frames(1200, 5'000);
    EXPECT_NEAR(feed.clock.delay_ms(), 1.7 * 16.667, 0.5);
    EXPECT_NEAR(feed.behind_ms(5'000), 5 + 1.7 * 16.667, 1);
}

TEST(RenderClock, adapts_to_changed_latency_within_8_percent_speed_change) {
    Feed feed;
    feed.frames(600, 5'000);
    feed.frames(1200, 80'000);
    EXPECT_NEAR(feed.behind_ms(80'000), 80 + 1.7 * 16.667, 3);
    feed.frames(1200, 5'000);
    EXPECT_NEAR(feed.behind_ms(5'000), 5 + 1.7 * 16.667, 3);
    EXPECT_GE(feed.least, 0.92 - 1e-9);
    EXPECT_LE(feed.greatest, 1.08 + 1e-9);
}

TEST(RenderClock, jumps_only_when_more_than_one_second_behind) {
    Feed feed;
    feed.frames(120, 1'500'000);
    feed.frames(1, 10'000);  // a faster route: it arrives before the previous frame
    const std::int64_t before = feed.clock.render_time_us();
    feed.clock.advance(feed.ours_us + 1'600'000);
    EXPECT_GT(feed.clock.render_time_us() - before, 1'000'000);
}

TEST(RenderClock, does_not_increase_the_delay_after_the_world_slept) {
    Feed feed;
    feed.frames(600, 5'000);
    // Four heartbeats per second for one minute.
    for (int k = 0; k < 240; k++) {
        feed.due_us += 250'000;
        feed.ours_us += 250'000;
        feed.clock.on_frame(feed.due_us, feed.ours_us + 5'000);
    }
    feed.frames(60, 5'000);
    EXPECT_NEAR(feed.clock.delay_ms(), 1.7 * 16.667, 1);
}

TEST(RenderClock, does_not_advance_while_the_local_clock_stands_or_goes_back) {
    Feed feed;
    feed.frames(10, 5'000);
    const std::int64_t shown = feed.clock.render_time_us();
    EXPECT_EQ(feed.clock.advance(feed.ours_us + 5'000), shown);
    EXPECT_EQ(feed.clock.advance(feed.ours_us - 900'000), shown);
}

TEST(RenderClock, returns_zero_before_the_first_frame) {
    RenderClock clock;
    EXPECT_EQ(clock.advance(1'000'000), 0);
}

}  // namespace jostle::client
