// SPDX-License-Identifier: MIT
//
// Truncated and corrupt recordings, and files that are not recordings.
#include <gtest/gtest.h>

#include <iterator>

#include "clients/cpp/recording/src/recording_format.h"
#include "jostle/client/recording_summary.h"
#include "tests/clients/cpp/recording/recorded_world.h"

namespace jostle::client {
namespace {

using namespace recording;

const RecordedWorld& three_seconds() {
    static const RecordedWorld made = record_world(180, 30);
    return made;
}

const RecordedWorld& short_recording() {
    static const RecordedWorld made = record_world(60, 20);
    return made;
}

// Offsets of all records, followed by that of the index.
std::vector<std::uint64_t> record_places(const std::string& file) {
    std::vector<std::uint64_t> places;
    for (std::uint64_t at = header_bytes;;) {
        places.push_back(at);
        const auto length = get<std::uint32_t>(file, at);
        if (length == 0) return places;
        at += record_header_bytes + length;
    }
}

std::string error_of_opening(const std::string& file) {
    const auto reader = opened(file);
    return reader.ok() ? "" : reader.error().message;
}

}  // namespace

TEST(DamagedRecording, reads_a_truncated_recording_up_to_the_cut) {
    const RecordedWorld& world = short_recording();
    const std::vector<std::uint64_t> places = record_places(world.file);
    const auto whole = opened(world.file).value().index();
    ASSERT_GT(world.file.size(), 2048u);
    for (std::size_t truncation_reason = 1;
         truncation_reason <= 1024 + (world.file.size() - places.back()); truncation_reason++) {
        const std::string rest = world.file.substr(0, world.file.size() - truncation_reason);
        auto reader = opened(rest);
        ASSERT_TRUE(reader.ok()) << reader.error().message;
        // All complete records are readable, and the index lists exactly these.
        const auto after = std::ranges::upper_bound(places, rest.size());
        ASSERT_EQ(reader->end(), *(after - 1)) << truncation_reason << " bytes short";
        ASSERT_NE(reader->truncation_reason(), "");
        const auto& index = reader->index();
        ASSERT_LE(index.size(), whole.size());
        ASSERT_TRUE(std::equal(index.begin(), index.end(), whole.begin()));
        ASSERT_TRUE(index.size() == whole.size() || whole[index.size()].offset >= reader->end());
        const std::uint32_t last = summarize(*reader).last_tick;
        Playback playback(*std::move(reader));
        ASSERT_TRUE(playback.seek(last));
        ASSERT_EQ(playback.view().frame(), world.truth.at(last));
    }
}

TEST(DamagedRecording, reports_where_a_recording_without_index_ends) {
    const std::string& file = three_seconds().file;
    const std::uint64_t index = record_places(file).back();
    EXPECT_EQ(opened(file.substr(0, index))->truncation_reason(),
              "byte " + std::to_string(index) + ": no index: the recording is truncated");
    std::string wrong = file;
    wrong[index + 20] = static_cast<char>(wrong[index + 20] ^ 1);
    EXPECT_EQ(opened(wrong)->truncation_reason(),
              "byte " + std::to_string(index) + ": the index is corrupt");
    EXPECT_EQ(opened(wrong)->index(), opened(file)->index()) << "the index was rebuilt";
    // Zero bytes, as a file system may append after a crash.
    EXPECT_EQ(opened(file.substr(0, index) + std::string(5000, '\0'))->end(), index);
}

TEST(DamagedRecording, reports_a_damaged_record_and_continues_at_the_next_keyframe) {
    const RecordedWorld& world = three_seconds();
    const auto index = opened(world.file).value().index();
    std::vector<RecordingEntry> keyframes;
    for (const RecordingEntry& entry : index)
        if (entry.kind == RecordingEntry::Kind::keyframe) keyframes.push_back(entry);
    ASSERT_GE(keyframes.size(), 4u);
    std::string damaged = world.file;
    const std::uint64_t at = keyframes[2].offset;
    damaged[at + 40] = static_cast<char>(damaged[at + 40] ^ 4);
    Playback playback(opened(damaged).value());
    const Status there = playback.seek(keyframes[2].frame);
    ASSERT_FALSE(there.ok());
    EXPECT_EQ(there.error().message,
              "byte " + std::to_string(at) + ": CRC mismatch: the record is corrupt");
    // Not every tick has a snapshot.
    const auto damaged_from = world.truth.lower_bound(keyframes[2].frame),
               whole_from = world.truth.lower_bound(keyframes[3].frame);
    const std::uint32_t after = std::next(whole_from, 3)->first;
    ASSERT_TRUE(playback.seek(after));
    EXPECT_EQ(playback.view().frame(), world.truth.at(after));
    ASSERT_TRUE(playback.seek(std::prev(damaged_from)->first));

    Playback again(opened(damaged).value());
    const RecordingVerification found = check(again);
    EXPECT_EQ(found.errors.size(), 2u) << "the record, and the index entry that refers to it";
    EXPECT_EQ(found.snapshots, world.truth.size() - static_cast<std::size_t>(
                                                        std::distance(damaged_from, whole_from)));
}

TEST(DamagedRecording, shows_the_rest_after_damage_in_the_middle) {
    const std::string& file = three_seconds().file;
    const std::vector<std::uint64_t> places = record_places(file);
    RecordingReader intact = opened(file).value();
    const RecordingSummary whole = summarize(intact);
    const std::size_t hit = places.size() / 2;
    std::string damaged = file;
    damaged.replace(places[hit], 200, std::string(200, '\x5a'));  // destroys lengths as well
    const auto lost = static_cast<std::uint64_t>(
                          std::ranges::upper_bound(places, places[hit] + 199) - places.begin()) -
                      hit;
    const auto count = [](const RecordingSummary& summary) {
        std::uint64_t all = 0;
        for (const auto& [kind, messages] : summary.messages) all += messages;
        return all;
    };
    for (const bool has_index : {true, false}) {
        RecordingReader reader =
            opened(has_index ? damaged : damaged.substr(0, places.back())).value();
        const RecordingSummary found = summarize(reader);
        EXPECT_EQ(found.last_tick, whole.last_tick);
        EXPECT_EQ(count(found), count(whole) - lost) << "only the damaged records are missing";
        EXPECT_EQ(found.errors, 1u);
        EXPECT_TRUE(found.first_error.starts_with("byte " + std::to_string(places[hit]) + ": "));
        Playback playback(std::move(reader));
        EXPECT_TRUE(playback.seek(whole.last_tick).ok());
    }
}

TEST(DamagedRecording, detects_any_damaged_byte_of_a_record) {
    const std::string& file = three_seconds().file;
    const std::vector<std::uint64_t> places = record_places(file);
    const std::uint64_t from = places[places.size() / 2], to = places[places.size() / 2 + 3];
    for (std::uint64_t at = from; at < to; at++) {
        std::string damaged = file;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        Playback playback(opened(damaged).value());
        ASSERT_FALSE(check(playback).errors.empty()) << "byte " << at;
    }
}

TEST(DamagedRecording, rejects_other_files_with_a_helpful_message) {
    EXPECT_EQ(error_of_opening(""),
              "byte 0: not a recording: the file does not start with JREC; use a file written by "
              "jostle-record");
    EXPECT_EQ(error_of_opening(std::string(100, 'x')), error_of_opening(""));
    std::string newer = three_seconds().file;
    newer[4] = 2;
    EXPECT_EQ(error_of_opening(newer),
              "byte 4: unsupported version 2; this program reads version 1; use a program of the "
              "same release");
    EXPECT_EQ(error_of_opening(newer.replace(4, 1, "\1").substr(0, 20)),
              "byte 16: the recording is empty: byte 16: truncated record "
              "header");
    const auto gone = RecordingReader::open("/nowhere/yard.rec");
    ASSERT_FALSE(gone.ok());
    EXPECT_EQ(gone.error().message, "cannot read /nowhere/yard.rec: No such file or directory");
}

TEST(DamagedRecording, rejects_an_implausible_length) {
    std::string file = three_seconds().file;
    const std::uint64_t at = record_places(file)[5];
    for (const int top : {0x02, 0x7f, 0xff}) {
        file[at + 3] = static_cast<char>(top);
        Playback playback(opened(file).value());
        const RecordingVerification found = check(playback);
        ASSERT_FALSE(found.errors.empty());
        EXPECT_TRUE(std::ranges::any_of(found.errors, [&](const std::string& fault) {
            return fault.starts_with("byte " + std::to_string(at) + ": message of ");
        }));
    }
}

}  // namespace jostle::client
