// SPDX-License-Identifier: MIT
#include "server/world/tick_clock.h"

#include "jostle/base/check.h"

namespace jostle::server {

TickClock::TickClock(Clock::time_point start, double hz, int catch_up_ticks_max)
    : start_(start), period_s_(1 / hz), catch_up_ticks_max_(catch_up_ticks_max) {}

Clock::time_point TickClock::next_due() const {
    return start_ + from_seconds(static_cast<double>(next_) * period_s_);
}

int TickClock::due(Clock::time_point now) {
    int count = 0;
    while (start_ + from_seconds(static_cast<double>(next_ + static_cast<std::uint64_t>(count)) *
                                 period_s_) <=
           now) {
        if (count < catch_up_ticks_max_) {
            count++;
            continue;
        }
        // Skip the oldest, so that the ticks that run are the latest ones.
        next_++;
        late_++;
    }
    ASSERT(count >= 0 && count <= catch_up_ticks_max_);
    return count;
}

Clock::time_point TickClock::begin_tick() {
    const Clock::time_point at = next_due();
    next_++;
    return at;
}

}  // namespace jostle::server
