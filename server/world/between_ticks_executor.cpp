// SPDX-License-Identifier: MIT
#include "server/world/between_ticks_executor.h"

#include <new>

namespace jostle::server {

Status BetweenTicksExecutor::run(const Task& task) {
    std::unique_lock lock(mutex_);
    if (closed_) return Error{ErrorCode::aborted, "the world was closed"};
    if (waiting_)
        return Error{ErrorCode::resource_exhausted,
                     "somebody else looks at this world; try again in a moment"};
    waiting_ = &task;
    changed_.wait_for(lock, timeout, [&] { return closed_ || waiting_ != &task; });
    // The world's thread takes it under the lock: what is still here was not begun.
    if (waiting_ != &task) {
        if (!failed_) return {};
        return Error{ErrorCode::resource_exhausted, "there is no memory to look at this world"};
    }
    waiting_ = nullptr;
    if (closed_) return Error{ErrorCode::aborted, "the world was closed"};
    return Error{ErrorCode::deadline_exceeded, "the world's tick has not ended for 5 s"};
}

void BetweenTicksExecutor::run_pending(HostedWorld& world) {
    if (!waiting_.load(std::memory_order_relaxed)) return;
    {
        const std::lock_guard lock(mutex_);
        if (!waiting_) return;
        // What a visitor lacks is not the world's fault.
        try {
            (*waiting_)(world);
            failed_ = false;
        } catch (const std::bad_alloc&) {
            failed_ = true;
        }
        waiting_ = nullptr;
    }
    changed_.notify_all();
}

void BetweenTicksExecutor::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
}

}  // namespace jostle::server
