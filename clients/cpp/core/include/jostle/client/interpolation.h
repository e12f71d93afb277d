// SPDX-License-Identifier: MIT
//
// Smooth poses from frames that arrive unevenly. What a picture shows is RenderClock's; poses lie
// between the two frames around it. When frames stop, motion goes on for at most 50 ms and then
// holds: bodies that collide cannot be guessed further. When they come again, what was guessed
// wrongly is walked off at a bounded speed (PoseError) instead of jumping. A body that went further
// than 100 m/s explain did not fly there: it is shown at the old place until the new frame's time.
// One thread at a time.
#pragma once

#include <deque>
#include <vector>

#include "jostle/client/pose_error.h"
#include "jostle/client/render_clock.h"
#include "jostle/snapshot/quantize.h"

namespace jostle::client {

struct SmoothPose {
    std::uint32_t entity = 0;
    wire::Pose pose;
};

class InterpolationBuffer {
public:
    // A frame was decoded: when its tick was due, on the server's clock, and when it came, on ours;
    // in microseconds. A frame that is not newer than the last one is left out.
    // After a rest, of which no frames were sent, its distance to the one before tells nothing.
    void add(wire::QuantizedFrame frame, std::int64_t server_us, std::int64_t arrived_us,
             bool after_rest = false);
    // What the newest frame shows was so until that time.
    void hold(std::int64_t server_us);
    void clear();

    // Where everything is to be drawn at a time on our clock, which should rise from call to call.
    // Entities of the later of the two frames, in rising order; empty before the first frame. A
    // body that is new stands where it appears.
    std::vector<SmoothPose> sample(std::int64_t now_us, const wire::QuantSpec& spec);

    const RenderClock& clock() const { return clock_; }

private:
    struct Timed {
        wire::QuantizedFrame frame;
        std::int64_t server_us;
    };
    struct RenderedPose {
        SmoothPose smooth_pose;
        BodySpeed body_speed;
        PoseError error;
    };
    // The two frames around a moment, and where between them it is; beyond 1 when it is later.
    struct FramePair {
        const Timed *a, *b;
        double t;
    };
    FramePair frames_around(double at_us) const;
    std::vector<RenderedPose> poses_at(double at_us, const wire::QuantSpec& spec) const;
    bool teleported_since(std::uint32_t entity, std::int64_t server_us,
                          const wire::QuantSpec& spec) const;
    void update_errors(const wire::QuantSpec& spec);

    RenderClock clock_;
    std::deque<Timed> frames_;  // in order of time; at most 64
    // The last picture: its time on our clock and on the server's, and what was the newest frame.
    std::int64_t last_sample_us_ = 0, last_render_time_us_ = 0, last_newest_frame_us_ = 0;
    std::vector<RenderedPose> rendered_;  // by entity
};

}  // namespace jostle::client
