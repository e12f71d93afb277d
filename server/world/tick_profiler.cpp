// SPDX-License-Identifier: MIT
#include "server/world/tick_profiler.h"

#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

Result<std::vector<TickProfile>> TickProfiler::record(Clock::duration time) {
    const Clock::time_point end = Clock::now() + time;
    std::unique_lock lock(mutex_);
    if (closed_) return Error{ErrorCode::aborted, "the world was closed"};
    if (recording_)
        return Error{ErrorCode::resource_exhausted,
                     "another request is recording this world; retry after it has ended"};
    recording_ = true;
    ticks_.clear();
    ticks_.reserve(ticks_max);  // here, so that the tick thread never allocates
    requested_ = true;
    changed_.wait_until(lock, end, [&] { return closed_ || ticks_.size() >= ticks_max; });
    requested_ = false;
    ASSERT(recording_);
    recording_ = false;
    return std::exchange(ticks_, {});
}

void TickProfiler::put(const TickProfile& tick) {
    bool is_full;
    {
        const std::lock_guard lock(mutex_);
        if (!recording_ || ticks_.size() >= ticks_max) return;
        ticks_.push_back(tick);
        ASSERT(ticks_.size() <= ticks_max);
        is_full = ticks_.size() >= ticks_max;
    }
    if (is_full) changed_.notify_all();
}

void TickProfiler::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
}

}  // namespace jostle::server
