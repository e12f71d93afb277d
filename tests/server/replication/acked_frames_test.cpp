// SPDX-License-Identifier: MIT
#include "server/replication/acked_frames.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

void send(AckedFrames& frames, std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t frame = first; frame <= last; frame++) frames.on_sent(frame);
}

}  // namespace

TEST(AckedFrames, unacknowledged_frames_are_not_baselines) {
    AckedFrames frames;
    send(frames, 1, 10);
    EXPECT_EQ(frames.newest(), 0u);
    EXPECT_EQ(frames.baselines_for(11), snapshot::BaselineFrames{});
    EXPECT_EQ(frames.last_sent(), 10u);
}

TEST(AckedFrames, baselines_are_the_newest_acknowledged_frames) {
    AckedFrames frames;
    send(frames, 1, 10);
    frames.on_ack(8, 0b1101);  // 7, 5 and 4 are acknowledged, 6 is not
    EXPECT_EQ(frames.newest(), 8u);
    const snapshot::BaselineFrames baselines = frames.baselines_for(11);
    EXPECT_EQ(baselines.baseline, 8u);
    EXPECT_EQ(baselines.baseline2, 4u)
        << "frame 6 was lost, and clients with other gaps have multiples of 4, too";
    EXPECT_EQ(baselines.baseline3, 0u);
}

TEST(AckedFrames, ignores_acks_of_unsent_frames) {
    AckedFrames frames;
    frames.on_sent(3);
    frames.on_sent(6);
    frames.on_ack(500, ~0u);
    frames.on_ack(5, 0);
    EXPECT_EQ(frames.newest(), 0u);
    frames.on_ack(35, 1u << 31);
    EXPECT_EQ(frames.newest(), 3u) << "32 frames earlier";
}

TEST(AckedFrames, stream_acks_do_not_confirm_datagrams) {
    AckedFrames frames;
    frames.on_sent(1, true);
    frames.on_sent(2, false);
    EXPECT_FALSE(frames.on_ack(2, 0));
    EXPECT_EQ(frames.newest(), 2u) << "the frame must be available as a baseline";
    EXPECT_TRUE(frames.on_ack(2, 1));
    EXPECT_FALSE(frames.on_ack(2, 1)) << "a repeated acknowledgement must not count";
}

TEST(AckedFrames, frames_older_than_32_are_not_baselines) {
    AckedFrames frames;
    frames.on_sent(1);
    frames.on_ack(1, 0);
    send(frames, 2, 32);
    EXPECT_EQ(frames.newest(), 1u);
    frames.on_sent(33);
    EXPECT_EQ(frames.newest(), 0u);
}

TEST(AckedFrames, reset_clears_all_baselines) {
    AckedFrames frames;
    send(frames, 1, 5);
    frames.on_ack(5, 0);
    frames.reset();
    frames.on_ack(5, 0);
    EXPECT_EQ(frames.newest(), 0u)
        << "an acknowledgement from before the keyframe request must be ignored";
    frames.on_sent(6);
    frames.on_ack(6, 0);
    EXPECT_EQ(frames.newest(), 6u);
    EXPECT_EQ(frames.known().last(), 6u);
}

}  // namespace jostle::server
