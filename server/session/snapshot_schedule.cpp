// SPDX-License-Identifier: MIT
#include "server/session/snapshot_schedule.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

void SnapshotSchedule::on_frame(std::uint32_t tick) {
    ASSERT(tick > last_frame_);
    const auto every = static_cast<std::uint32_t>(flow_.divider());
    if (write_blocked_ && last_frame_ != 0)
        skipped_pending_ += (tick - 1) / every - last_frame_ / every;
    last_frame_ = tick;
}

void SnapshotSchedule::request(std::uint32_t tick, Clock::time_point now) {
    is_due_ = is_due_ || flow_.may_send(tick, now);
}

void SnapshotSchedule::on_sent(std::uint32_t tick, Clock::time_point now) {
    ASSERT(is_due_);
    is_due_ = false;
    last_snapshot_ = now;
    last_frame_ = std::max(last_frame_, tick);
    flow_.on_sent(tick, now);
}

}  // namespace jostle::server
