// SPDX-License-Identifier: MIT
#include "server/world/time_scale.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

constexpr auto slice = std::chrono::milliseconds(250);
constexpr auto judged_min = std::chrono::seconds(1);
constexpr auto report_period = std::chrono::minutes(1);

}  // namespace

void TimeScale::count_tick(Clock::time_point now) {
    if (!slices_.empty()) now = std::max(now, slices_.back().begun);
    if (slices_.empty() || now - slices_.back().begun >= slice) slices_.push_back({.begun = now});
    slices_.back().ticks++;
    while (slices_.size() > 1 && now - slices_[1].begun >= from_seconds(window_seconds))
        slices_.pop_front();
}

double TimeScale::value(Clock::time_point now) const {
    if (slices_.empty() || now - slices_.front().begun < judged_min) return 1;
    int ticks = 0;
    for (const Slice& part : slices_) ticks += part.ticks;
    const std::chrono::duration<double> elapsed = now - slices_.front().begun;
    return std::min(1.0, ticks / (hz_ * elapsed.count()));
}

TimeScale::Change TimeScale::poll_change(Clock::time_point now) {
    if (slices_.empty() || now - slices_.front().begun < from_seconds(window_seconds))
        return Change::none;
    const bool was_behind = is_behind_;
    is_behind_ = value(now) < (was_behind ? caught_up_above : behind_below);
    if (is_behind_ && (!was_behind || now - reported_ >= report_period)) {
        reported_ = now;
        return Change::behind;
    }
    return was_behind && !is_behind_ ? Change::caught_up : Change::none;
}

}  // namespace jostle::server
