// SPDX-License-Identifier: MIT
#include "server/limits/overload_control.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "server/limits/cadence.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

constexpr auto period_length = 250ms;
constexpr int sent_min = 4;
// Every tenth tick: the next classes would not be worth much, and would recover slowly.
constexpr int level_max = 6;
static_assert(Cadence::divisors[level_max] == 10);
// A snapshot is late after this share of its interval, and this share may be late. A stall of the
// machine does not last for two periods.
constexpr double late_after = 0.8, late_share_max = 0.15;
constexpr int late_periods = 2;
// The next faster class must leave more room, so that the level does not alternate.
constexpr double late_for_faster_after = 0.6, late_for_faster_share_max = 0.05;
// After a change, snapshots that were delayed before it are not counted.
constexpr auto settling = 100ms;

}  // namespace

void OverloadControl::on_sent(double delay_s, double interval_s, double faster_interval_s,
                              Clock::time_point now) {
    ASSERT(interval_s > 0 && faster_interval_s > 0);
    if (period_.begun == Clock::time_point{}) period_.begun = now;
    if (now < period_.begun) return;
    period_.sent++;
    period_.late += delay_s > late_after * interval_s ? 1 : 0;
    period_.late_for_faster += delay_s > late_for_faster_after * faster_interval_s ? 1 : 0;
    period_.delay_s = std::max(period_.delay_s, delay_s);
    if (now - period_.begun >= period_length && period_.sent >= sent_min) evaluate(now);
}

void OverloadControl::evaluate(Clock::time_point now) {
    const Period period = period_;
    period_ = {.begun = now};
    send_delay_s_ = std::max(period.delay_s, send_delay_s_ / 2);
    const bool is_late = period.late > late_share_max * period.sent;
    late_periods_ = is_late ? late_periods_ + 1 : 0;
    if (late_periods_ >= late_periods && level_ < level_max)
        level_++;
    else if (level_ > 0 && period.late_for_faster < late_for_faster_share_max * period.sent)
        level_--;
    else
        return;
    late_periods_ = 0;
    period_.begun = now + settling;
}

}  // namespace jostle::server
