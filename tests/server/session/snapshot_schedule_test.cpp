// SPDX-License-Identifier: MIT
#include "server/session/snapshot_schedule.h"

#include <gtest/gtest.h>

#include "tests/server/session/session_start.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

TEST(SnapshotSchedule, the_first_snapshot_is_due_at_once) {
    SnapshotSchedule schedule({}, 60, 1);
    EXPECT_TRUE(schedule.is_due());
    schedule.on_frame(100);
    schedule.on_sent(100, start);
    EXPECT_FALSE(schedule.is_due());
    EXPECT_EQ(schedule.last_frame(), 100u);
}

TEST(SnapshotSchedule, requests_only_ticks_that_the_client_wants) {
    SnapshotSchedule schedule({}, 60, 3);
    schedule.on_frame(99);
    schedule.on_sent(99, start);
    schedule.on_frame(100);
    schedule.request(start + 16ms);
    EXPECT_FALSE(schedule.is_due());
    schedule.on_frame(102);
    schedule.request(start + 50ms);
    EXPECT_TRUE(schedule.is_due());
    EXPECT_EQ(schedule.due_tick(), 102u);
}

// A session that is called late sends the tick of its class all the same.
TEST(SnapshotSchedule, requests_the_newest_tick_of_the_class_and_counts_missed_ones) {
    SnapshotSchedule schedule({}, 60, 2);
    schedule.on_frame(100);
    schedule.on_sent(100, start);
    schedule.on_frame(101);
    schedule.request(start + 16ms);
    EXPECT_FALSE(schedule.is_due());
    schedule.on_frame(107);  // 102, 104 and 106 passed
    schedule.request(start + 117ms);
    EXPECT_TRUE(schedule.is_due());
    EXPECT_EQ(schedule.due_tick(), 106u);
    EXPECT_EQ(schedule.ticks_missed(), 4u);
    schedule.defer();
    EXPECT_FALSE(schedule.is_due());
    EXPECT_EQ(schedule.deferred(), 1u);
}

TEST(SnapshotSchedule, ticks_that_passed_during_a_write_are_not_missed) {
    SnapshotSchedule schedule({}, 60, 1);
    schedule.on_frame(100);
    schedule.on_sent(100, start);
    schedule.set_write_blocked(true);
    schedule.on_frame(105);
    schedule.request(start + 83ms);
    EXPECT_TRUE(schedule.is_due());
    EXPECT_EQ(schedule.ticks_missed(), std::nullopt);
}

TEST(SnapshotSchedule, counts_wanted_frames_that_pass_during_a_write) {
    SnapshotSchedule schedule({}, 60, 3);
    schedule.on_frame(99);
    schedule.set_write_blocked(true);
    schedule.on_frame(109);  // 102, 105 and 108 passed
    EXPECT_EQ(schedule.skipped_pending(), 3u);
    schedule.set_write_blocked(false);
    schedule.on_frame(130);
    EXPECT_EQ(schedule.skipped(), 3u);
}

TEST(SnapshotSchedule, heartbeat_is_due_four_times_per_second) {
    SnapshotSchedule schedule({.heartbeats_per_second = 4}, 60, 1);
    schedule.on_frame(1);
    schedule.on_sent(1, start);
    EXPECT_FALSE(schedule.heartbeat_due(start + 249ms));
    EXPECT_TRUE(schedule.heartbeat_due(start + 250ms));
}

}  // namespace
}  // namespace jostle::server
