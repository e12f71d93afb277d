// SPDX-License-Identifier: MIT
//
// Smooth poses from frames that arrive in bursts. The world is shown a little in the past, where
// there is a frame on either side. How far in the past adapts slowly to the jitter. When frames
// stop, motion goes on for at most 50 ms and then holds: bodies that collide cannot be guessed
// further. One thread at a time.
#pragma once

#include <deque>
#include <vector>

#include "jostle/client/clock_sync.h"
#include "wire/quantize.h"

namespace jostle::client {

struct SmoothPose {
    std::uint32_t entity = 0;
    wire::Pose pose;
};

class InterpolationBuffer {
public:
    // A frame was decoded. Both times are on the server's clock, in microseconds: of the tick, and
    // of its arrival. A frame that is not newer than the last one is left out.
    void add(const wire::QuantizedFrame& frame, std::int64_t server_us, std::int64_t arrived_us);
    // What the newest frame shows was so until that time.
    void hold(std::int64_t server_us);
    void clear();

    // Where everything is to be drawn at a time on the server's clock: between the two frames
    // around now_us - delay. Entities of the later frame, in rising order; empty before the first
    // frame.
    std::vector<SmoothPose> sample(std::int64_t now_us, const wire::QuantSpec& spec) const;

    // Approaches the shortest way + max(1.7 intervals, interval + jitter), by at most 5 % or 1 ms a
    // frame. Of the last 128 frames: the way is from tick to arrival, jitter is its 95th percentile
    // less the shortest.
    double delay_ms() const { return delay_us_ / 1000; }

private:
    struct Timed {
        wire::QuantizedFrame frame;
        std::int64_t server_us;
    };
    void adapt(std::int64_t server_us, std::int64_t arrived_us);

    std::deque<Timed> frames_;        // in order of time; at most 64
    std::deque<double> lateness_us_;  // of the last frames: arrival less tick
    double interval_us_ = 0, delay_us_ = 0;
};

}  // namespace jostle::client
