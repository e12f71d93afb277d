// SPDX-License-Identifier: MIT
#include "server/world/single_step_control.h"

namespace jostle::server {

Result<int> SingleStepControl::take(int steps, Clock::duration timeout) {
    const Clock::time_point end = Clock::now() + timeout;
    std::unique_lock lock(mutex_);
    if (closed_) return Error{ErrorCode::aborted, "the world was closed"};
    if (wanted_)
        return Error{ErrorCode::resource_exhausted,
                     "somebody else steps this world; try again when they are done"};
    allowed_ = steps;
    shown_ = begun_ = 0;
    wanted_ = true;
    taken_.wait_until(lock, end, [&] { return !wanted_ || shown_ == steps; });
    wanted_ = false;
    return shown_;
}

bool SingleStepControl::begin_step() {
    if (!wanted_.load(std::memory_order_relaxed)) return false;
    const std::lock_guard lock(mutex_);
    if (!wanted_ || allowed_ == 0) return false;
    allowed_--;
    begun_++;
    return true;
}

void SingleStepControl::end_tick() {
    if (!wanted_.load(std::memory_order_relaxed)) return;
    {
        const std::lock_guard lock(mutex_);
        shown_ = begun_;
        if (allowed_ > 0) return;
    }
    taken_.notify_all();
}

void SingleStepControl::withdraw() {
    {
        const std::lock_guard lock(mutex_);
        wanted_ = false;
    }
    taken_.notify_all();
}

void SingleStepControl::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
        wanted_ = false;
    }
    taken_.notify_all();
}

}  // namespace jostle::server
