// SPDX-License-Identifier: MIT
//
// Which moment of the server's world a picture shows. It is a little in the past, so that there is
// a frame on either side although frames arrive unevenly. This clock never goes backwards, and its
// speed stays within 8 % of 1, whatever the link does: a change of the delay is walked, not jumped.
//
// It needs no ping: both its times come with frames. One thread at a time.
#pragma once

#include <cstdint>
#include <deque>

namespace jostle::client {

class RenderClock {
public:
    // A frame arrived: when its tick was due, on the server's clock, and when it came, on ours; in
    // microseconds. One that is not newer than the last is left out. After a rest no frames were
    // sent, so how long that was tells nothing of the rhythm.
    void on_frame(std::int64_t server_us, std::int64_t arrived_us, bool after_rest = false);

    // A picture is drawn: what it shows, on the server's clock. now_us is on our clock; when it did
    // not rise, nothing changes. 0 before the first frame.
    //
    // It approaches now - shortest way - delay. More than a second behind it jumps there: the
    // only step that it takes.
    std::int64_t advance(std::int64_t now_us);

    std::int64_t render_time_us() const { return static_cast<std::int64_t>(render_time_us_); }
    double speed() const { return speed_; }  // over the last picture
    // Behind what could be shown at the soonest: max(1.7 intervals, interval + jitter), at most
    // 300 ms; 60 ms at first. The interval is the median of the last 256 frames. Jitter is the 95th
    // percentile of how much later one came than the quickest. What came more than 200 ms after the
    // tick before tells nothing, for the world rested; nor does what came at once with the frame
    // that ended a silence of half a second: no delay makes up for such. Growing takes about a
    // second, shrinking about four.
    double delay_ms() const { return delay_us_ / 1000; }

private:
    struct Arrival {
        double lateness_us;      // arrival less tick: the way, and how the clocks differ
        double interval_us;      // since the tick before
        bool counts_for_jitter;  // tells of the jitter
    };
    void adapt();
    void update_target_delay();

    std::deque<Arrival> arrivals_;  // the last 256
    std::int64_t newest_us_ = 0, arrived_us_ = 0;
    double min_lateness_us_ = 0;  // lateness of the quickest of them
    double delay_us_ = 60'000, target_delay_us_ = delay_us_;
    int frames_until_update_ = 0;  // frames; what is wanted is looked at with every eighth
    bool gap_ended_ = false;       // and what it held up still comes
    bool started_ = false;
    std::int64_t now_us_ = 0;
    double render_time_us_ = 0, speed_ = 1;
};

}  // namespace jostle::client
