// SPDX-License-Identifier: MIT
//
// Smooth poses from frames that arrive in bursts: the world is shown a little in the past, where
// there is a frame on either side. How far adapts slowly to the jitter seen. When frames stop,
// motion goes on for at most 50 ms, then holds: bodies that collide cannot be guessed further.
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
    // A frame was decoded. Times in microseconds: of the tick on the server's clock, of its arrival
    // on the same clock.
    void add(const wire::QuantizedFrame& frame, std::int64_t server_us, std::int64_t arrived_us);
    void clear();

    // Where everything is to be drawn now (server clock): between the two frames around now -
    // delay.
    std::vector<SmoothPose> sample(std::int64_t now_us, const wire::QuantSpec& spec) const;

    // max(1.7 intervals, interval + 95th percentile of jitter), approached by at most 5 % a frame.
    double delay_ms() const { return delay_us_ / 1000; }

private:
    struct Timed {
        wire::QuantizedFrame frame;
        std::int64_t server_us;
    };
    void adapt(std::int64_t server_us, std::int64_t arrived_us);

    std::deque<Timed> frames_;        // in order of time; at most 64
    std::deque<double> lateness_us_;  // of the last frames against the earliest
    double interval_us_ = 0, delay_us_ = 0;
};

}  // namespace jostle::client
