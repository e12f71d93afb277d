// SPDX-License-Identifier: MIT
//
// The newest frames of a world, for who asks what was where a moment ago: clients see the world as
// it was, and aim at that. The world's thread puts; any thread looks. What is looked at stays for
// as long as it is held.
#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>

#include "server/world/command.h"
#include "server/world/frame.h"

namespace jostle::server {

// A moment of a world's past, between two of its frames.
struct RewindFrames {
    FramePtr before, after;  // the same when nothing is between them
    double fraction = 0;     // of the way from `before` to `after`, 0 to 1
    bool clamped = false;    // a moment before it was asked for, of which no frame is left
};

class FrameRing {
public:
    // As many as are in so many ms of a world of that rate, and at least the newest one.
    FrameRing(double history_ms, double hz);

    void put(FramePtr frame);
    // What is later than the newest frame is as it is there. Nothing before the first frame.
    std::optional<RewindFrames> at(const ViewTime& view_time) const;

    std::size_t frames_max() const { return frames_max_; }

private:
    const std::size_t frames_max_;
    mutable std::mutex mutex_;
    std::deque<FramePtr> frames_;  // one a tick
};

}  // namespace jostle::server
