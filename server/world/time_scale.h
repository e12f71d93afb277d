// SPDX-License-Identifier: MIT
//
// The ratio of simulated to elapsed time of a world. A world that skips ticks falls behind: its
// time scale is below 1. Used on the tick thread.
#pragma once

#include <deque>
#include <optional>

#include "server/util/clock.h"

namespace jostle::server {

class TimeScale {
public:
    static constexpr double window_seconds = 5;
    static constexpr double behind_below = 0.95, caught_up_above = 0.98;

    explicit TimeScale(double hz) : hz_(hz) {}

    // Counts a tick at its start. A tick of a resting world (tick_loop.h) is counted when it was
    // due, which may be before the previous one started.
    void count_tick(Clock::time_point now);
    // The world was paused: forgets all ticks.
    void reset() { *this = TimeScale(hz_); }
    // The rate of the ticks changes: forgets all ticks.
    void set_hz(double hz) { *this = TimeScale(hz); }
    // Over the last 5 s, 0 to 1; 1 if there is less than 1 s to judge by.
    double value(Clock::time_point now) const;

    // A change that is worth a log line: the time scale fell below 0.95 over a whole window, or
    // rose above 0.98 again. Reports a world that stays behind once per minute.
    enum class Change { none, behind, caught_up };
    Change poll_change(Clock::time_point now);

private:
    // The ticks of a quarter of a second.
    struct Slice {
        Clock::time_point begun;
        int ticks = 0;
    };

    double hz_;
    std::deque<Slice> slices_;  // of the last 5 s, oldest first
    bool is_behind_ = false;
    Clock::time_point reported_{};
};

}  // namespace jostle::server
