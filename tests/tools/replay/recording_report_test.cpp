// SPDX-License-Identifier: MIT
//
// Reports of jostle-replay.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "jostle/client/recording_summary.h"
#include "tests/clients/cpp/recording/recorded_world.h"
#include "tools/replay/recording_report.h"

namespace jostle::client {
namespace {

const RecordedWorld& one_second() {
    static const RecordedWorld made = record_world(60, 30);
    return made;
}

}  // namespace

TEST(RecordingReport, summarizes_the_file) {
    RecordingReader recording = opened(one_second().file).value();
    const RecordingSummary summary = summarize(recording);
    const RecordingWriter::Counts& written = one_second().counts;
    EXPECT_EQ(summary.first_tick, written.first_tick);
    EXPECT_EQ(summary.last_tick, written.last_tick);
    EXPECT_EQ(summary.keyframes, written.keyframes);
    EXPECT_EQ(summary.messages.at("snapshot"), written.snapshots);
    EXPECT_NEAR(summary.seconds, 1, 0.02);
    const auto json = nlohmann::json::parse(replay::to_json(recording, summary));
    EXPECT_EQ(json["world"], "yard");
    EXPECT_EQ(json["tick_hz"], 60);
    EXPECT_EQ(json["keyframes"], 3) << "the first snapshot, and one every 0.5 s";
    EXPECT_EQ(json["recorded"], "2023-11-14T22:13:20Z");
    EXPECT_EQ(json["truncation"], "");
    const std::string text = replay::to_text(recording, summary);
    EXPECT_NE(text.find("yard ("), std::string::npos) << text;
    EXPECT_EQ(text.find("truncated"), std::string::npos) << text;
}

TEST(RecordingReport, lists_bodies_and_poses_of_a_tick) {
    Playback playback(opened(one_second().file).value());
    const std::uint32_t tick = one_second().counts.last_tick;
    ASSERT_TRUE(playback.seek(tick));
    const auto json = nlohmann::json::parse(replay::state_json(playback, tick));
    EXPECT_EQ(json["frame_tick"], tick);
    ASSERT_EQ(json["entities"].size(), one_second().truth.at(tick).entities.size());
    EXPECT_EQ(json["entities"][0]["type"], "static");
    EXPECT_EQ(json["entities"][1]["type"], "dynamic");
    EXPECT_NEAR(json["entities"][1]["position"][1], 0.5, 0.01) << "the lower box stands";
    const std::string text = replay::state_text(playback, tick);
    EXPECT_EQ(std::ranges::count(text, '\n'),
              static_cast<std::ptrdiff_t>(2 + json["entities"].size()));
}

}  // namespace jostle::client
