// SPDX-License-Identifier: MIT
#include "server/session/snapshot_schedule.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

void SnapshotSchedule::on_frame(std::uint32_t tick) {
    ASSERT(tick > last_frame_);
    const std::uint32_t step = flow_.step();
    if (write_blocked_ && last_frame_ != 0)
        skipped_pending_ += (tick - 1) / step - last_frame_ / step;
    previous_frame_ = std::exchange(last_frame_, tick);
}

void SnapshotSchedule::request(Clock::time_point now) {
    if (is_due_) return;
    const std::uint32_t step = flow_.step();
    const std::uint32_t newest = last_frame_ / step * step;
    const std::uint32_t tick = newest > previous_frame_ ? newest : last_frame_;
    if (!flow_.may_send(tick, now)) return;
    is_due_ = true;
    due_tick_ = tick;
    ticks_missed_.reset();
    if (!write_blocked_) ticks_missed_ = tick - std::min(tick, (previous_frame_ / step + 1) * step);
}

void SnapshotSchedule::defer() {
    ASSERT(is_due_);
    is_due_ = false;
    deferred_++;
}

void SnapshotSchedule::on_sent(std::uint32_t tick, Clock::time_point now) {
    ASSERT(is_due_);
    is_due_ = false;
    due_tick_ = 0;
    last_snapshot_ = now;
    last_frame_ = std::max(last_frame_, tick);
    flow_.on_sent(tick, now);
}

}  // namespace jostle::server
