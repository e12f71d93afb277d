// SPDX-License-Identifier: MIT
//
// Playback of a recording reproduces the recorded frames, from the start and from any tick.
#include "jostle/client/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ranges>

#include "jostle/client/recording_summary.h"
#include "tests/clients/cpp/recording/recorded_world.h"

namespace jostle::client {
namespace {

// Ten seconds at 60 ticks per second, with a keyframe every second.
const RecordedWorld& ten_seconds() {
    static const RecordedWorld made = record_world(600, 60);
    return made;
}

Playback played(const RecordedWorld& world) {
    return Playback(opened(world.file).value());
}

// Players and attributes, without pings, which seeking may show up to a second later.
std::string text_of(const WorldData& data) {
    std::string text;
    for (v1::Player player : data.players() | std::views::values) {
        player.clear_ping_ms();
        text += player.SerializeAsString();
    }
    for (const auto& [target, attributes] : data.attributes())
        for (const auto& [key, attribute] : attributes) text += attribute.SerializeAsString();
    return text;
}

}  // namespace

TEST(Playback, reproduces_the_live_view_tick_by_tick) {
    const RecordedWorld& world = ten_seconds();
    Playback playback = played(world);
    EXPECT_EQ(playback.recording().truncation_reason(), "");
    EXPECT_EQ(playback.recording().welcome().world_name(), "yard");
    auto expected = world.truth.begin();
    std::uint64_t snapshots = 0;
    for (; playback.next().value(); snapshots++, ++expected) {
        ASSERT_NE(expected, world.truth.end());
        ASSERT_EQ(playback.view().frame(), expected->second);
    }
    EXPECT_EQ(snapshots, world.truth.size());
    EXPECT_GT(snapshots, 590u) << "one snapshot per tick";
    EXPECT_FALSE(playback.next().value()) << "playback stays at the end";
}

TEST(Playback, seeking_gives_the_same_state_as_playing_from_the_start) {
    const RecordedWorld& world = ten_seconds();
    Playback sequential = played(world), seeking = played(world);
    EXPECT_GE(world.counts.keyframes, 10u);
    std::size_t most = 0;
    while (sequential.next().value()) {
        const std::uint32_t tick = sequential.view().frame().frame;
        // Seeks elsewhere first, so that each seek starts from a keyframe.
        ASSERT_TRUE(seeking.seek(tick < 300 ? world.counts.last_tick : world.counts.first_tick));
        const Status sought = seeking.seek(tick);
        ASSERT_TRUE(sought.ok()) << sought.error().message;
        ASSERT_EQ(seeking.view().frame(), sequential.view().frame()) << "tick " << tick;
        ASSERT_EQ(seeking.view().channels().size(), sequential.view().channels().size());
        ASSERT_EQ(seeking.arrived_us(), sequential.arrived_us());
        const auto &told = seeking.view().entities(), &truth = sequential.view().entities();
        ASSERT_EQ(told.size(), truth.size());
        ASSERT_EQ(told.size(), world.listed.at(tick));
        ASSERT_TRUE(std::ranges::equal(told, truth, [](const auto& a, const auto& b) {
            return a.second.SerializeAsString() == b.second.SerializeAsString();
        }));
        ASSERT_EQ(text_of(seeking.view().data()), text_of(sequential.view().data()));
        most = std::max(most, told.size());
    }
    const WorldData& data = sequential.view().data();
    EXPECT_EQ(data.players().begin()->second.name(), "recorder 585");
    EXPECT_EQ(data.attributes().size(), 1u);
    EXPECT_EQ(most, 4u + 3u) << "bodies of the scene and thrown balls";
}

TEST(Playback, seeks_forward_from_the_current_position_when_closer) {
    Playback playback = played(ten_seconds());
    const std::uint32_t first = ten_seconds().counts.first_tick;
    for (std::uint32_t tick = first; tick < first + 200; tick += 3) {
        ASSERT_TRUE(playback.seek(tick));
        EXPECT_EQ(playback.view().frame(), ten_seconds().truth.at(tick));
    }
    EXPECT_TRUE(playback.next().value());
    EXPECT_EQ(playback.view().frame().frame, first + 199);
}

TEST(Playback, rejects_a_missing_tick_and_names_the_available_range) {
    Playback playback = played(ten_seconds());
    const auto& counts = ten_seconds().counts;
    const Status early = playback.seek(counts.first_tick - 1), late = playback.seek(1'000'000);
    ASSERT_FALSE(early.ok());
    EXPECT_EQ(early.error().message, "tick " + std::to_string(counts.first_tick - 1) +
                                         " is before the recording, which starts at tick " +
                                         std::to_string(counts.first_tick));
    ASSERT_FALSE(late.ok());
    EXPECT_EQ(late.error().message, "tick 1000000 is after the recording, which ends at tick " +
                                        std::to_string(counts.last_tick));
    EXPECT_TRUE(playback.seek(counts.last_tick));
}

TEST(Playback, verifies_an_intact_recording) {
    Playback playback = played(ten_seconds());
    const RecordingVerification found = check(playback);
    EXPECT_EQ(found.snapshots, ten_seconds().truth.size());
    EXPECT_TRUE(found.errors.empty()) << found.errors.front();
}

TEST(RecordingWriter, accepts_only_one_stream_of_a_whole_world) {
    std::ostringstream out;
    RecordingWriter writer(out, 0);
    v1::ServerMessage message;
    message.mutable_pong();
    EXPECT_FALSE(writer.add(message.SerializeAsString(), 0))
        << "the Welcome must be the first message";
    message.mutable_welcome()->set_cells(true);
    const Status part = writer.add(message.SerializeAsString(), 0);
    ASSERT_FALSE(part.ok());
    EXPECT_NE(part.error().message.find("join without an interest"), std::string::npos);
    message.mutable_welcome()->set_cells(false);
    message.mutable_welcome()->set_client_id(1);
    EXPECT_TRUE(writer.add(message.SerializeAsString(), 5));
    EXPECT_FALSE(writer.add(message.SerializeAsString(), 6)) << "another stream";
    EXPECT_FALSE(writer.add("\xff\xff", 7));
    EXPECT_FALSE(writer.add("", 7));
    EXPECT_TRUE(writer.finish());
    EXPECT_EQ(opened(out.str())->welcome().client_id(), 1u);
}

TEST(RecordingWriter, reports_a_full_disk_and_keeps_written_records) {
    std::ostringstream out;
    RecordingWriter writer(out, 0);
    v1::ServerMessage message;
    message.mutable_welcome()->set_client_id(1);
    ASSERT_TRUE(writer.add(message.SerializeAsString(), 0));
    const std::string good = out.str();
    out.setstate(std::ios::badbit);
    message.mutable_pong();
    const Status full = writer.add(message.SerializeAsString(), 1);
    ASSERT_FALSE(full.ok());
    EXPECT_EQ(full.error().code, ErrorCode::resource_exhausted);
    EXPECT_NE(full.error().message.find("after byte " + std::to_string(good.size())),
              std::string::npos);
    EXPECT_EQ(opened(good)->welcome().client_id(), 1u);
}

}  // namespace jostle::client
