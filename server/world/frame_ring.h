// SPDX-License-Identifier: MIT
//
// The newest frames of a world, for lag compensation: clients render the world as it was some time
// ago and aim at that. The tick thread puts frames; any thread reads them. Readers share the
// ownership of the frames that they got.
#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>

#include "server/world/command.h"
#include "server/world/frame.h"

namespace jostle::server {

// A time in the past of a world, between two of its frames.
struct RewindFrames {
    FramePtr before, after;  // equal for a time exactly at a frame
    double fraction = 0;     // from `before` to `after`, 0 to 1
    bool clamped = false;    // the requested time is older than the oldest frame, which is used
};

class FrameRing {
public:
    // Holds the frames of `history_ms` at a rate of `hz`, and at least the newest one.
    FrameRing(double history_ms, double hz);

    void put(FramePtr frame);
    // A time after the newest frame yields the newest frame. Nothing: no frame was put yet.
    std::optional<RewindFrames> at(const ViewTime& view_time) const;

    std::size_t frames_max() const { return frames_max_; }

private:
    const std::size_t frames_max_;
    mutable std::mutex mutex_;
    std::deque<FramePtr> frames_;  // one per tick, consecutive ticks
};

}  // namespace jostle::server
