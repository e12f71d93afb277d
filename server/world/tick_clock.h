// SPDX-License-Identifier: MIT
//
// When the next tick is due. Deadlines are start + n * period, so they do not drift however late a
// tick begins.
//
// When late: up to catch_up_ticks_max ticks are run at once; what is later than that is given up:
// the schedule moves forward and the ticks that never ran are counted as late.
#pragma once

#include <cstdint>

#include "server/util/clock.h"

namespace jostle::server {

class TickClock {
public:
    TickClock(Clock::time_point start, double hz, int catch_up_ticks_max);

    Clock::time_point next_due() const;
    // How many ticks to run now, 0 to catch_up_ticks_max; each is then taken with begin_tick().
    int due(Clock::time_point now);
    // When the tick that begins now was due.
    Clock::time_point begin_tick();

    std::uint32_t late_ticks() const { return late_; }

private:
    Clock::time_point start_;
    double period_s_;
    int catch_up_ticks_max_;
    std::uint64_t next_ = 1;  // number of the next tick since start_
    std::uint32_t late_ = 0;
};

}  // namespace jostle::server
