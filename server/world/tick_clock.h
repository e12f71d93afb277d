// SPDX-License-Identifier: MIT
//
// The schedule of ticks. Tick n is due at start + n * period, so late ticks cause no drift.
//
// After a delay, up to catch_up_ticks_max due ticks run at once. Older ones are skipped and counted
// as late ticks.
#pragma once

#include <cstdint>

#include "server/util/clock.h"

namespace jostle::server {

class TickClock {
public:
    TickClock(Clock::time_point start, double hz, int catch_up_ticks_max);

    // The due time of the next tick, or of a later one.
    Clock::time_point next_due(int ticks_later = 0) const;
    // The number of ticks to run now, 0 to catch_up_ticks_max, plus `expected` ticks that are not
    // late. Call begin_tick() for each of them.
    int due(Clock::time_point now, int expected = 0);
    // Returns the time at which the tick was due.
    Clock::time_point begin_tick();

    // Changes the rate from the next tick on.
    void set_hz(double hz);

    std::uint32_t late_ticks() const { return late_; }

private:
    Clock::time_point start_;
    double period_s_;
    int catch_up_ticks_max_;
    std::uint64_t next_ = 1;  // number of the next tick since start_
    std::uint32_t late_ = 0;
};

}  // namespace jostle::server
