// SPDX-License-Identifier: MIT
#include "server/util/work_pool.h"

#include <sys/resource.h>
#include <unistd.h>

#include <exception>
#include <utility>

#include "jostle/base/check.h"
#include "server/util/log.h"

namespace jostle::server {

WorkPool::WorkPool(int threads, std::size_t queue_max, int niceness) : queue_max_(queue_max) {
    ASSERT(threads > 0 && queue_max > 0);
    for (int i = 0; i < threads; i++) threads_.emplace_back([this, niceness] { run(niceness); });
}

WorkPool::~WorkPool() {
    stop();
}

bool WorkPool::add(std::function<void()> work) {
    ASSERT(work);
    {
        const std::lock_guard lock(mutex_);
        if (stopping_ || queue_.size() >= queue_max_) return false;
        queue_.push_back(std::move(work));
        ASSERT(queue_.size() <= queue_max_);
    }
    changed_.notify_one();
    return true;
}

void WorkPool::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_)
        if (thread.joinable()) thread.join();
}

void WorkPool::run(int niceness) {
    // Applies to this thread only (Linux). If the call fails, the work runs at normal priority.
    static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness));
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
        if (queue_.empty()) return;
        const std::function<void()> work = std::move(queue_.front());
        ASSERT(work);
        queue_.pop_front();
        lock.unlock();
        try {
            work();
        } catch (const std::exception& error) {
            log_error("work pool: a task failed: {}", error.what());
        }
        lock.lock();
    }
}

}  // namespace jostle::server
