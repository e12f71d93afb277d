// SPDX-License-Identifier: MIT
//
// Determines the server time that a rendered frame shows. It is slightly in the past, so that there
// is a frame on either side although frames arrive at irregular intervals. The clock never runs
// backwards, and its speed stays within 8 % of 1 on any connection: it approaches a new delay
// gradually.
//
// The clock needs no ping: both of its times come with frames. One thread at a time.
#pragma once

#include <cstdint>
#include <deque>

namespace jostle::client {

/// The clock of rendered frames.
class RenderClock {
public:
    /// Adds an arrived frame. `server_us`: due time of its tick on the server's clock.
    /// `arrived_us`: arrival on the local clock. Ignores a frame that is not newer than the last
    /// one. `after_rest`: the server had stopped sending frames because nothing moved, so the
    /// interval says nothing about the rate.
    void on_frame(std::int64_t server_us, std::int64_t arrived_us, bool after_rest = false);

    /// Returns the server time to render at the local time now_us. If now_us did not increase,
    /// nothing changes. Returns 0 before the first frame.
    ///
    /// The result approaches now - shortest transit - delay. If it is more than 1 s behind, it
    /// jumps there; this is the only discontinuity.
    std::int64_t advance(std::int64_t now_us);

    /// Result of the last advance(), us.
    std::int64_t render_time_us() const { return static_cast<std::int64_t>(render_time_us_); }
    double speed() const { return speed_; }  ///< over the last rendered frame
    /// Delay behind the earliest possible time: max(1.7 intervals, interval + jitter), at most 300
    /// ms; initially 60 ms. The interval is the median of the last 256 frames. The jitter is the
    /// 95th percentile of the lateness relative to the fastest frame. Frames more than 200 ms after
    /// the previous tick are ignored, because the world rested. Frames that arrive in a burst after
    /// a gap of 0.5 s are ignored too, because no delay compensates for such gaps. The delay grows
    /// within about 1 s and shrinks within about 4 s.
    double delay_ms() const { return delay_us_ / 1000; }

private:
    struct Arrival {
        double lateness_us;      // arrival minus due time: transit time plus clock offset
        double interval_us;      // since the previous tick
        bool counts_for_jitter;  // used for the jitter
    };
    void adapt();
    void update_target_delay();

    std::deque<Arrival> arrivals_;  // the last 256
    std::int64_t newest_us_ = 0, arrived_us_ = 0;
    double min_lateness_us_ = 0;  // lateness of the fastest of them
    double delay_us_ = 60'000, target_delay_us_ = delay_us_;
    int frames_until_update_ = 0;  // the target delay is updated every eighth frame
    bool gap_ended_ = false;       // the delayed frames of the gap are still arriving
    bool started_ = false;
    std::int64_t now_us_ = 0;
    double render_time_us_ = 0, speed_ = 1;
};

}  // namespace jostle::client
