// SPDX-License-Identifier: MIT
//
// What is in a recording, and whether all of it can be played.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "jostle/client/playback.h"

namespace jostle::client {

struct RecordingSummary {
    std::uint32_t first_tick = 0, last_tick = 0;      // of snapshots; 0: there is none
    double seconds = 0;                               // from the first message to the last
    std::uint64_t message_bytes = 0;                  // without what the file adds
    std::uint64_t keyframes = 0, keyframe_bytes = 0;  // those and what they take
    std::size_t entities = 0, entities_max = 0;       // at the end, and at most
    std::map<std::string, std::uint64_t> messages{};  // of each kind: how many
    std::string first_error{};                        // that ended the count; empty: none
};
// Reads every record, and decodes no snapshot.
RecordingSummary summarize(RecordingReader& recording);

struct RecordingVerification {
    static constexpr std::size_t errors_max = 100;  // more are not listed

    std::uint64_t snapshots = 0;  // that were decoded and agree with their CRC
    std::vector<std::string> errors;
};
// Decodes everything, going on at the next keyframe after each fault, and makes the index anew.
RecordingVerification check(Playback& playback);

}  // namespace jostle::client
