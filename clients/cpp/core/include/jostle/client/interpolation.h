// SPDX-License-Identifier: MIT
//
// Smooth poses from frames that arrive at irregular intervals. RenderClock determines the time to
// render; poses are interpolated between the two frames around it. If no frame is newer, motion is
// extrapolated for at most 50 ms and then held, because collisions cannot be extrapolated further.
// When frames resume, the displayed error decays at a bounded speed (PoseError) instead of jumping.
// A body that moved faster than 100 m/s between two frames was teleported: it is shown at the old
// position until the time of the new frame. One thread at a time.
#pragma once

#include <deque>
#include <vector>

#include "jostle/client/pose_error.h"
#include "jostle/client/render_clock.h"
#include "jostle/snapshot/quantize.h"

namespace jostle::client {

/// The pose of one entity.
struct SmoothPose {
    std::uint32_t entity = 0;
    snapshot::Pose pose;
};

/// Buffer of frames, sampled once per rendered frame.
class InterpolationBuffer {
public:
    /// Adds a decoded frame. `server_us`: due time of its tick on the server's clock. `arrived_us`:
    /// arrival on the local clock. Ignores a frame that is not newer than the last one.
    /// `after_rest`: the server had stopped sending frames because nothing moved, so the interval
    /// to the previous frame says nothing about the rate.
    void add(snapshot::QuantizedFrame frame, std::int64_t server_us, std::int64_t arrived_us,
             bool after_rest = false);
    /// The newest frame remains valid until this time.
    void hold(std::int64_t server_us);
    /// Removes all frames.
    void clear();

    /// Returns the poses to render at a local time, which must increase from call to call. The
    /// result contains the entities of the later of the two frames, sorted by id; it is empty
    /// before the first frame. A new body is shown at its first pose.
    std::vector<SmoothPose> sample(std::int64_t now_us, const snapshot::QuantSpec& spec);

    /// The clock that determines the time to render.
    const RenderClock& clock() const { return clock_; }

private:
    struct Timed {
        snapshot::QuantizedFrame frame;
        std::int64_t server_us;
    };
    struct RenderedPose {
        SmoothPose smooth_pose;
        BodySpeed body_speed;
        PoseError error;
    };
    // The two frames around a time, and the fraction between them; above 1 if the time is later.
    struct FramePair {
        const Timed *a, *b;
        double t;
    };
    FramePair frames_around(double at_us) const;
    std::vector<RenderedPose> poses_at(double at_us, const snapshot::QuantSpec& spec) const;
    bool teleported_since(std::uint32_t entity, std::int64_t server_us,
                          const snapshot::QuantSpec& spec) const;
    void update_errors(const snapshot::QuantSpec& spec);

    RenderClock clock_;
    std::deque<Timed> frames_;  // sorted by time; at most 64
    // The last rendered frame: its local time, its server time, and the newest frame at that time.
    std::int64_t last_sample_us_ = 0, last_render_time_us_ = 0, last_newest_frame_us_ = 0;
    std::vector<RenderedPose> rendered_;  // by entity
};

}  // namespace jostle::client
