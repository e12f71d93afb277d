// SPDX-License-Identifier: MIT
#include "host/tick_gate.h"

#include <utility>

namespace jostle::server {

void TickGate::set_paused(bool paused) {
    {
        const std::lock_guard lock(mutex_);
        paused_ = paused;
        allowed_ = 0;
        if (!paused) untold_ = 0;
    }
    taken_.notify_all();
}

Result<int> TickGate::take_steps(int steps, Clock::duration patience) {
    const Clock::time_point end = Clock::now() + patience;
    std::unique_lock lock(mutex_);
    if (closed_) return Error{ErrorCode::aborted, "the world was closed"};
    if (!paused())
        return Error{ErrorCode::failed_precondition,
                     "the world is not paused: it steps by itself; pause it first"};
    if (stepping_)
        return Error{ErrorCode::resource_exhausted,
                     "somebody else steps this world; try again when they are done"};
    stepping_ = true;
    allowed_ = untold_ = steps;
    taken_.wait_until(lock, end, [&] { return closed_ || !paused() || untold_ == 0; });
    stepping_ = false;
    allowed_ = 0;
    return std::exchange(untold_, 0);
}

// Every tick of every world comes through here: it pays for the lock only when it is paused.
bool TickGate::begin_tick() {
    if (!paused()) return true;
    const std::lock_guard lock(mutex_);
    if (!paused()) return true;
    if (allowed_ == 0) return false;
    allowed_--;
    return true;
}

void TickGate::end_tick() {
    if (!paused()) return;
    {
        const std::lock_guard lock(mutex_);
        if (untold_ <= allowed_) return;  // this tick took no step of those
        untold_ = allowed_;
        if (untold_ > 0) return;
    }
    taken_.notify_all();
}

void TickGate::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    taken_.notify_all();
}

}  // namespace jostle::server
