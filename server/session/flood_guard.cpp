// SPDX-License-Identifier: MIT
#include "server/session/flood_guard.h"

#include <chrono>

namespace jostle::server {

namespace {

constexpr auto notice_period = std::chrono::seconds(1);

}  // namespace

FloodGuard::Verdict FloodGuard::on_excess(Clock::time_point now) {
    excess_++;
    if (now - notified_ < notice_period)
        return excess_ > flood_factor * messages_per_second_ ? Verdict::disconnect : Verdict::drop;
    notified_ = now;
    excess_ = 1;
    return Verdict::notify;
}

}  // namespace jostle::server
