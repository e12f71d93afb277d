// SPDX-License-Identifier: MIT
//
// Plays a recording into a WorldView, like that of a live client: forward from snapshot to
// snapshot, or directly to a tick by way of the preceding keyframe. One thread at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/client/recording_reader.h"
#include "jostle/client/world_view.h"

namespace jostle::client {

/// Player of a recording.
class Playback {
public:
    explicit Playback(RecordingReader recording);

    /// Advances to the next snapshot, including the messages before it. Returns false at the end.
    /// Errors contain the byte offset; skip_to_keyframe() continues after an error.
    Result<bool> next();
    /// Seeks to a tick: the newest snapshot that is not later. Returns an error if the recording
    /// does not contain it or if a record on the way is damaged; the state of the view is then
    /// unspecified.
    Status seek(std::uint32_t tick);
    /// Advances to the next keyframe. Returns false if there is none.
    Result<bool> skip_to_keyframe();

    /// The view of the world; empty before the first snapshot.
    const WorldView& view() const { return view_; }
    /// Arrival time of the current snapshot since the start of the recording, us.
    std::uint64_t arrived_us() const { return arrived_us_; }
    RecordingReader& recording() { return recording_; }

private:
    Status find_next_snapshot();
    Error broken(Error error);
    Status apply(const v1::ServerMessage& message, std::uint64_t offset);
    Status restart_at(const RecordingEntry& keyframe);
    const RecordingEntry* keyframe_before(std::uint32_t tick) const;

    RecordingReader recording_;
    WorldView view_;
    std::uint64_t position_ = 0;  // of the first record that was not applied
    std::uint64_t arrived_us_ = 0;
    bool incomplete_ = false;  // a record was skipped since the last keyframe
    // The next snapshot, once it was found, and the records before it.
    std::optional<RecordingReader::Record> next_snapshot_;
    std::vector<std::uint64_t> persistent_records_;
};

}  // namespace jostle::client
