// SPDX-License-Identifier: MIT
//
// When a client gets its next snapshot. A window of snapshots that were sent but not acknowledged
// bounds how stale a slow client can become: without it, buffers on the way fill for seconds before
// a write ever blocks. Clients that keep hitting their window are sent every second, third, ...
// tick until they keep up again. One stall, however long, is one hit: a machine that paused for a
// moment is not a slow client.
#pragma once

#include <cstdint>
#include <deque>

#include "base/clock.h"
#include "config/config.h"

namespace jostle::server {

class FlowControl {
public:
    // `hz`: ticks a second. `divider`: the client asked for every divider-th tick.
    FlowControl(const StreamSettings& settings, double hz, int divider);

    // Whether the snapshot of this tick should go out now. Counts a skip when only the window
    // forbids it.
    bool may_send(std::uint32_t tick, Clock::time_point now);
    void on_sent(std::uint32_t frame, Clock::time_point now);
    void on_ack(std::uint32_t frame, Clock::time_point now);

    int window() const { return window_; }
    int in_flight() const { return static_cast<int>(flights_.size()); }
    std::uint32_t skipped() const { return skipped_; }
    // Snapshots that were not even tried, because the client did not keep up before.
    std::uint32_t slowed() const { return slowed_; }
    double round_trip_s() const { return rtt_s_; }  // of the last ack; 0: there was none
    int divider() const { return divider_ * slowdown_; }

private:
    struct Flight {
        std::uint32_t frame;
        Clock::time_point at;
    };
    void update_window(Clock::duration round_trip);
    void hit_window(Clock::time_point now);

    StreamSettings settings_;
    double hz_;
    int divider_, slowdown_ = 1, window_;
    std::deque<Flight> flights_;
    double rtt_s_ = 0, rtt_min_s_ = 0, jitter_s_ = 0;
    bool measured_ = false;
    bool blocked_ = false;  // the window is full, and that was counted
    std::uint32_t skipped_ = 0, slowed_ = 0;
    Clock::time_point last_hit_{}, clean_since_{};
};

}  // namespace jostle::server
