// SPDX-License-Identifier: MIT
//
// Plays a recording into a WorldView, which is what live clients see by: forward from snapshot to
// snapshot, or at once to any tick, by way of the keyframe before it. One thread at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/client/recording_reader.h"
#include "jostle/client/world_view.h"

namespace jostle::client {

class Playback {
public:
    explicit Playback(RecordingReader recording);

    // To the next snapshot, with what came before it. False: there is none. An error names the
    // byte; skip_to_keyframe() goes on after it.
    Result<bool> next();
    // To what was seen in that tick: the newest snapshot that is not later. An error: the recording
    // does not have it, or a record on the way is damaged; the view is somewhere then.
    Status seek(std::uint32_t tick);
    // To before the next keyframe. False: there is none.
    Result<bool> skip_to_keyframe();

    // Before the first snapshot: of an empty world.
    const WorldView& view() const { return view_; }
    // Of the newest snapshot: since the recording began.
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
    std::uint64_t position_ = 0;  // of what was not applied yet
    std::uint64_t arrived_us_ = 0;
    bool incomplete_ = false;  // something was left out since the last keyframe
    // The next snapshot, once it was looked for, and what stands before it.
    std::optional<RecordingReader::Record> next_snapshot_;
    std::vector<std::uint64_t> persistent_records_;
};

}  // namespace jostle::client
