// SPDX-License-Identifier: MIT
#include "server/world/single_step_control.h"

#include "jostle/base/check.h"

namespace jostle::server {

Result<int> SingleStepControl::step(int steps, Clock::duration timeout) {
    const Clock::time_point end = Clock::now() + timeout;
    std::unique_lock lock(mutex_);
    if (closed_) return Error{ErrorCode::aborted, "the world was closed"};
    if (requested_)
        return Error{ErrorCode::resource_exhausted,
                     "another request is stepping this world; retry after it has ended"};
    allowed_ = steps;
    published_ = begun_ = 0;
    requested_ = true;
    taken_.wait_until(lock, end, [&] { return !requested_ || published_ == steps; });
    requested_ = false;
    ASSERT(published_ >= 0 && published_ <= begun_ && begun_ <= steps);
    return published_;
}

bool SingleStepControl::begin_step() {
    if (!requested_.load(std::memory_order_relaxed)) return false;
    const std::lock_guard lock(mutex_);
    if (!requested_ || allowed_ == 0) return false;
    allowed_--;
    begun_++;
    return true;
}

void SingleStepControl::end_tick() {
    if (!requested_.load(std::memory_order_relaxed)) return;
    {
        const std::lock_guard lock(mutex_);
        ASSERT(published_ <= begun_);
        published_ = begun_;
        if (allowed_ > 0) return;
    }
    taken_.notify_all();
}

void SingleStepControl::cancel() {
    {
        const std::lock_guard lock(mutex_);
        requested_ = false;
    }
    taken_.notify_all();
}

void SingleStepControl::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
        requested_ = false;
    }
    taken_.notify_all();
}

}  // namespace jostle::server
