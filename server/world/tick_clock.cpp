// SPDX-License-Identifier: MIT
#include "server/world/tick_clock.h"

#include "jostle/base/check.h"

namespace jostle::server {

TickClock::TickClock(Clock::time_point start, double hz, int catch_up_ticks_max)
    : start_(start), period_s_(1 / hz), catch_up_ticks_max_(catch_up_ticks_max) {}

Clock::time_point TickClock::next_due(int ticks_later) const {
    ASSERT(ticks_later >= 0);
    return start_ +
           from_seconds(static_cast<double>(next_ + static_cast<std::uint64_t>(ticks_later)) *
                        period_s_);
}

int TickClock::due(Clock::time_point now, int expected) {
    ASSERT(expected >= 0);
    int count = 0;
    while (next_due(count) <= now) {
        if (count < catch_up_ticks_max_ + expected) {
            count++;
            continue;
        }
        // Skip the oldest, so that the ticks that run are the latest ones.
        next_++;
        late_++;
    }
    ASSERT(count >= 0 && count <= catch_up_ticks_max_ + expected);
    return count;
}

void TickClock::set_hz(double hz) {
    ASSERT(hz > 0);
    const auto ticks = static_cast<double>(next_ - 1);
    start_ += from_seconds(ticks * period_s_) - from_seconds(ticks / hz);
    period_s_ = 1 / hz;
}

Clock::time_point TickClock::begin_tick() {
    const Clock::time_point at = next_due();
    next_++;
    return at;
}

}  // namespace jostle::server
