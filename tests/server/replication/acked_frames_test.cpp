// SPDX-License-Identifier: MIT
#include "server/replication/acked_frames.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

void send(AckedFrames& frames, std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t frame = first; frame <= last; frame++) frames.on_sent(frame);
}

}  // namespace

TEST(AckedFrames, what_nobody_acknowledged_is_no_base) {
    AckedFrames frames;
    send(frames, 1, 10);
    EXPECT_EQ(frames.newest(), 0u);
    EXPECT_EQ(frames.baselines_for(11), wire::BaselineFrames{});
    EXPECT_EQ(frames.last_sent(), 10u);
}

TEST(AckedFrames, bases_are_the_newest_that_the_client_has_though_others_were_lost) {
    AckedFrames frames;
    send(frames, 1, 10);
    frames.on_ack(8, 0b1101);  // 7, 5 and 4, but not 6
    EXPECT_EQ(frames.newest(), 8u);
    const wire::BaselineFrames baselines = frames.baselines_for(11);
    EXPECT_EQ(baselines.baseline, 8u);
    EXPECT_EQ(baselines.baseline2, 5u) << "at least half as far back as the base: 6 was lost";
    EXPECT_EQ(baselines.baseline3, 0u);
}

TEST(AckedFrames, an_ack_of_what_was_never_sent_counts_for_nothing) {
    AckedFrames frames;
    frames.on_sent(3);
    frames.on_sent(6);
    frames.on_ack(500, ~0u);
    frames.on_ack(5, 0);
    EXPECT_EQ(frames.newest(), 0u);
    frames.on_ack(35, 1u << 31);
    EXPECT_EQ(frames.newest(), 3u) << "32 frames before";
}

TEST(AckedFrames, an_ack_of_what_the_stream_brought_says_nothing_of_datagrams) {
    AckedFrames frames;
    frames.on_sent(1, true);
    frames.on_sent(2, false);
    EXPECT_FALSE(frames.on_ack(2, 0));
    EXPECT_EQ(frames.newest(), 2u) << "but it is a base";
    EXPECT_TRUE(frames.on_ack(2, 1));
    EXPECT_FALSE(frames.on_ack(2, 1)) << "no news";
}

TEST(AckedFrames, of_what_was_sent_33_frames_ago_nobody_says_that_the_client_still_has_it) {
    AckedFrames frames;
    frames.on_sent(1);
    frames.on_ack(1, 0);
    send(frames, 2, 32);
    EXPECT_EQ(frames.newest(), 1u);
    frames.on_sent(33);
    EXPECT_EQ(frames.newest(), 0u);
}

TEST(AckedFrames, a_client_that_lost_track_has_nothing_until_it_says_more) {
    AckedFrames frames;
    send(frames, 1, 5);
    frames.on_ack(5, 0);
    frames.reset();
    frames.on_ack(5, 0);
    EXPECT_EQ(frames.newest(), 0u) << "that ack is older than its complaint";
    frames.on_sent(6);
    frames.on_ack(6, 0);
    EXPECT_EQ(frames.newest(), 6u);
    EXPECT_EQ(frames.known().last(), 6u);
}

}  // namespace jostle::server
