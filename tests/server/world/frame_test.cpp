// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <memory>

#include "server/world/frame.h"

namespace jostle::server {

namespace {

FramePtr frame_of(std::uint32_t tick) {
    auto frame = std::make_shared<Frame>();
    frame->tick = tick;
    return frame;
}

TEST(FrameRing, retains_the_configured_history_and_returns_surrounding_frames) {
    FrameRing ring(400, 60);
    EXPECT_EQ(ring.frames_max(), 25u);
    EXPECT_FALSE(ring.at({5, 0.5})) << "before the first frame";
    for (std::uint32_t tick = 1; tick <= 100; tick++) ring.put(frame_of(tick), true);
    const auto between = ring.at({90, 0.25});
    ASSERT_TRUE(between);
    EXPECT_EQ(between->before->tick, 90u);
    EXPECT_EQ(between->after->tick, 91u);
    EXPECT_EQ(between->fraction, 0.25);
    EXPECT_FALSE(between->clamped);
    const auto whole = ring.at({76, 0});
    EXPECT_EQ(whole->before, whole->after);
    EXPECT_EQ(whole->before->tick, 76u) << "the oldest of the 25";
    EXPECT_FALSE(whole->clamped);
}

TEST(FrameRing, clamps_to_the_oldest_frame_and_reports_it) {
    FrameRing ring(400, 60);
    for (std::uint32_t tick = 1; tick <= 100; tick++) ring.put(frame_of(tick), true);
    for (const std::uint32_t tick : {75u, 1u, 0u}) {
        const auto checkpoint_copy = ring.at({tick, 0.9});
        EXPECT_EQ(checkpoint_copy->before->tick, 76u);
        EXPECT_EQ(checkpoint_copy->after->tick, 76u);
        EXPECT_TRUE(checkpoint_copy->clamped) << tick;
    }
}

TEST(FrameRing, clamps_future_times_to_the_newest_frame) {
    FrameRing ring(400, 60);
    for (std::uint32_t tick = 1; tick <= 100; tick++) ring.put(frame_of(tick), true);
    for (const ViewTime view_time : {ViewTime{100, 0.5}, ViewTime{4'000'000'000, 0}}) {
        EXPECT_EQ(ring.at(view_time)->before->tick, 100u);
        EXPECT_EQ(ring.at(view_time)->after->tick, 100u);
        EXPECT_FALSE(ring.at(view_time)->clamped);
    }
}

TEST(FrameRing, retains_past_frames_only_while_clients_watch) {
    FrameRing ring(400, 60);
    for (std::uint32_t tick = 1; tick <= 10; tick++) ring.put(frame_of(tick), false);
    EXPECT_EQ(ring.at({9, 0})->before->tick, 10u);
    EXPECT_TRUE(ring.at({9, 0})->clamped);
    for (std::uint32_t tick = 11; tick <= 20; tick++) ring.put(frame_of(tick), true);
    EXPECT_EQ(ring.at({10, 0})->before->tick, 10u);
    EXPECT_FALSE(ring.at({10, 0})->clamped);
    ring.put(frame_of(21), false);
    EXPECT_TRUE(ring.at({20, 0})->clamped);
}

// A world that rested has no frames of the ticks in between.
TEST(FrameRing, drops_frames_from_before_a_gap) {
    FrameRing ring(400, 60);
    for (const std::uint32_t tick : {1, 2, 3, 18, 19}) ring.put(frame_of(tick), true);
    EXPECT_EQ(ring.at({18, 0.5})->before->tick, 18u);
    EXPECT_EQ(ring.at({18, 0.5})->after->tick, 19u);
    EXPECT_EQ(ring.at({10, 0})->before->tick, 18u);
    EXPECT_TRUE(ring.at({10, 0})->clamped);
}

TEST(FrameRing, zero_history_retains_only_the_newest_frame) {
    FrameRing ring(0, 60);
    ring.put(frame_of(7), true);
    ring.put(frame_of(8), true);
    EXPECT_EQ(ring.at({7, 0})->before->tick, 8u);
    EXPECT_TRUE(ring.at({7, 0})->clamped);
}

}  // namespace

}  // namespace jostle::server
