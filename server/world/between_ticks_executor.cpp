// SPDX-License-Identifier: MIT
#include "server/world/between_ticks_executor.h"

#include <new>
#include <string>

#include "jostle/base/check.h"

namespace jostle::server {

Status BetweenTicksExecutor::run(const Task& task) {
    std::unique_lock lock(mutex_);
    if (closed_) return Error{ErrorCode::aborted, "the world was closed"};
    if (waiting_)
        return Error{ErrorCode::resource_exhausted,
                     "another request already waits for this world; retry in a second"};
    ASSERT(task);
    waiting_ = &task;
    changed_.wait_for(lock, timeout, [&] { return closed_ || waiting_ != &task; });
    // The tick thread runs the task under the lock, so a task that still waits was not started.
    if (waiting_ != &task) {
        if (!failed_) return {};
        return Error{ErrorCode::resource_exhausted, "out of memory while copying the world"};
    }
    waiting_ = nullptr;
    if (closed_) return Error{ErrorCode::aborted, "the world was closed"};
    return Error{ErrorCode::deadline_exceeded,
                 "the tick of the world did not end within " +
                     std::to_string(std::chrono::seconds(timeout).count()) + " s"};
}

void BetweenTicksExecutor::run_pending(HostedWorld& world) {
    if (!waiting_.load(std::memory_order_relaxed)) return;
    {
        const std::lock_guard lock(mutex_);
        if (!waiting_) return;
        // A task that runs out of memory must not end the world.
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
