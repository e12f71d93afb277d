// SPDX-License-Identifier: MIT
//
// The time scale of a world that keeps its rate, skips ticks, stands still or was paused.
#include "server/world/time_scale.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

// Counts the ticks of `seconds` seconds at `rate` per second and returns the end.
Clock::time_point run_ticks(TimeScale& scale, Clock::time_point from, double seconds, double rate) {
    const int ticks = static_cast<int>(seconds * rate);
    for (int i = 1; i <= ticks; i++) scale.count_tick(from + from_seconds(i / rate));
    return from + from_seconds(seconds);
}

constexpr Clock::time_point time_zero{1h};

TEST(TimeScale, is_one_at_the_rate_of_the_world_and_before_a_second_has_passed) {
    TimeScale scale(60);
    EXPECT_EQ(scale.value(time_zero), 1);
    const auto end = run_ticks(scale, time_zero, 20, 60);
    EXPECT_NEAR(scale.value(end), 1, 0.01);
    EXPECT_EQ(scale.poll_change(end), TimeScale::Change::none);
}

TEST(TimeScale, is_the_share_of_ticks_that_ran) {
    TimeScale scale(60);
    const auto end = run_ticks(scale, time_zero, 20, 42);
    EXPECT_NEAR(scale.value(end), 0.7, 0.02);
}

TEST(TimeScale, falls_while_no_tick_runs) {
    TimeScale scale(60);
    const auto end = run_ticks(scale, time_zero, 20, 60);
    EXPECT_NEAR(scale.value(end + 5s), 0.5, 0.03);
}

TEST(TimeScale, reports_a_world_that_falls_behind_and_catches_up_once_each) {
    TimeScale scale(60);
    auto now = run_ticks(scale, time_zero, 10, 60);
    int behind = 0, caught_up = 0;
    const auto go = [&](double seconds, double rate) {
        for (int i = 0; i < static_cast<int>(4 * seconds); i++) {
            now = run_ticks(scale, now, 0.25, rate);
            const TimeScale::Change change = scale.poll_change(now);
            behind += change == TimeScale::Change::behind ? 1 : 0;
            caught_up += change == TimeScale::Change::caught_up ? 1 : 0;
        }
    };
    go(30, 48);
    EXPECT_EQ(behind, 1);
    EXPECT_EQ(caught_up, 0);
    go(10, 60);
    EXPECT_EQ(behind, 1);
    EXPECT_EQ(caught_up, 1);
    go(130, 48);
    EXPECT_EQ(behind, 4) << "again once per minute";
}

TEST(TimeScale, a_pause_does_not_count) {
    TimeScale scale(60);
    auto now = run_ticks(scale, time_zero, 10, 60);
    scale.reset();
    now = run_ticks(scale, now + 30s, 8, 60);
    EXPECT_NEAR(scale.value(now), 1, 0.01);
}

// A world that hovers about the limit is not reported again and again.
TEST(TimeScale, reports_one_change_of_a_value_about_the_limit) {
    TimeScale scale(100);
    Clock::time_point now{};
    int behind = 0, caught_up = 0;
    for (int second = 0; second < 50; second++) {
        const int ticks = second % 2 == 0 ? 92 : 97;
        for (int k = 0; k < ticks; k++) {
            now += std::chrono::nanoseconds(1'000'000'000 / ticks);
            scale.count_tick(now);
            const TimeScale::Change change = scale.poll_change(now);
            behind += change == TimeScale::Change::behind ? 1 : 0;
            caught_up += change == TimeScale::Change::caught_up ? 1 : 0;
        }
    }
    EXPECT_EQ(behind, 1);
    EXPECT_EQ(caught_up, 0);
}

}  // namespace
}  // namespace jostle::server
