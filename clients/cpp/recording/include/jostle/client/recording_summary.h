// SPDX-License-Identifier: MIT
//
// Contents of a recording, and verification that all of it can be played.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "jostle/client/playback.h"

namespace jostle::client {

/// Contents of a recording.
struct RecordingSummary {
    std::uint32_t first_tick = 0, last_tick = 0;      ///< of snapshots; 0: none
    double seconds = 0;                               ///< from the first message to the last
    std::uint64_t message_bytes = 0;                  ///< without the overhead of the file
    std::uint64_t keyframes = 0, keyframe_bytes = 0;  ///< number of keyframes and their size
    std::size_t entities = 0, entities_max = 0;       ///< at the end, and maximum
    std::uint64_t user_messages = 0, player_events = 0, attribute_updates = 0;  ///< numbers of them
    std::map<std::string, std::uint64_t> messages{};  ///< number of messages by kind
    std::uint64_t errors = 0;   ///< number of places with corrupt records, which are skipped
    std::string first_error{};  ///< empty: none
};
/// Reads every intact record without decoding snapshots.
RecordingSummary summarize(RecordingReader& recording);

/// Result of check().
struct RecordingVerification {
    static constexpr std::size_t errors_max = 100;  ///< further errors are not listed

    std::uint64_t snapshots = 0;  ///< snapshots that were decoded and match their CRC
    std::vector<std::string> errors;
};
/// Decodes the whole recording, continuing at the next keyframe after each error, and rebuilds the
/// index.
RecordingVerification check(Playback& playback);

}  // namespace jostle::client
