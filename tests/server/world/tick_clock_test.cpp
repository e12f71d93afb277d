// SPDX-License-Identifier: MIT
#include "server/world/tick_clock.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

const Clock::time_point first_tick{};

TEST(TickClock, deadlines_do_not_drift) {
    TickClock clock(first_tick, 60, 4);
    for (int i = 0; i < 60 * 60; ++i) {
        // However late each tick begins, within its period.
        const Clock::time_point now = clock.next_due() + std::chrono::microseconds(i % 16000);
        ASSERT_EQ(clock.due(now), 1);
        clock.begin_tick();
    }
    EXPECT_LE(std::chrono::abs(clock.next_due() - (first_tick + 60s + from_seconds(1.0 / 60))),
              1us);
    EXPECT_EQ(clock.late_ticks(), 0u);
}

TEST(TickClock, nothing_is_due_before_its_time) {
    TickClock clock(first_tick, 50, 4);
    EXPECT_EQ(clock.due(first_tick + 19999us), 0);
    EXPECT_EQ(clock.due(first_tick + 20ms), 1);
}

TEST(TickClock, catches_up_to_the_limit_and_skips_the_rest) {
    TickClock clock(first_tick, 100, 4);
    EXPECT_EQ(clock.due(first_tick + 35ms), 3);
    EXPECT_EQ(clock.late_ticks(), 0u);
    for (int i = 0; i < 3; ++i) clock.begin_tick();
    EXPECT_EQ(clock.due(first_tick + 1s), 4) << "97 are due, 4 are run";
    EXPECT_EQ(clock.late_ticks(), 93u);
    EXPECT_EQ(clock.begin_tick(), first_tick + 970ms) << "the latest ones";
}

}  // namespace
}  // namespace jostle::server
