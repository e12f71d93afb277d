// SPDX-License-Identifier: MIT
#include "server/world/tick_pool.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

// Passing a due time on to another thread costs about as much as a tick of this length.
constexpr auto short_tick = std::chrono::microseconds(100);
constexpr auto stuck_after = std::chrono::milliseconds(50);

}  // namespace

TickPool::TickPool(int threads) {
    ASSERT(threads >= 1);
    const std::lock_guard lock(mutex_);
    for (int k = 0; k < threads; k++) start_thread();
}

TickPool::~TickPool() {
    {
        const std::lock_guard lock(mutex_);
        ASSERT(waiting_.empty());
        stopping_ = true;
    }
    work_.notify_all();
    next_due_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

std::shared_ptr<TickPool> TickPool::for_processors() {
    const unsigned processors = std::thread::hardware_concurrency();  // 0: unknown
    return std::make_shared<TickPool>(std::max(2, static_cast<int>(processors)));
}

void TickPool::add_thread_if_stuck(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (has_watcher_ || waiting_.empty()) return;
    if (now - waiting_.begin()->first <= stuck_after) return;
    if (idle_ > 0)
        work_.notify_one();  // a tick takes longer than the one before
    else
        start_thread();
}

std::size_t TickPool::threads() const {
    const std::lock_guard lock(mutex_);
    return threads_.size();
}

void TickPool::start_thread() {
    threads_.emplace_back([this] { work(); });
}

void TickPool::add(PooledLoop& loop) {
    const std::lock_guard lock(mutex_);
    insert(loop);
    if (!has_watcher_ && idle_ > 0) work_.notify_one();
}

// If no thread waits for the next due time, the caller has to see to it.
void TickPool::insert(PooledLoop& loop) {
    const auto [at, added] = waiting_.emplace(loop.wake_at_, &loop);
    ASSERT(added);
    // The thread that waits for the next due time waits for too long.
    if (at == waiting_.begin() && has_watcher_) next_due_.notify_one();
}

void TickPool::remove(PooledLoop& loop) {
    std::unique_lock lock(mutex_);
    loop.ends_ = true;
    if (!loop.runs_) waiting_.erase({loop.wake_at_, &loop});
    ended_.wait(lock, [&] { return !loop.runs_; });
}

void TickPool::wake(PooledLoop& loop) {
    const std::lock_guard lock(mutex_);
    if (loop.runs_ || waiting_.erase({loop.wake_at_, &loop}) == 0) return;  // or it has ended
    loop.end_rest();
    insert(loop);
    if (!has_watcher_ && idle_ > 0) work_.notify_one();
}

void TickPool::work() {
    std::unique_lock lock(mutex_);
    while (!stopping_) {
        if (!waiting_.empty() && waiting_.begin()->first <= Clock::now())
            run_first(lock);
        else
            wait_for_work(lock);
    }
}

void TickPool::wait_for_work(std::unique_lock<std::mutex>& lock) {
    if (waiting_.empty() || has_watcher_) {
        idle_++;
        work_.wait(lock);
        idle_--;
        return;
    }
    has_watcher_ = true;
    const Clock::time_point due = waiting_.begin()->first;  // the element may go meanwhile
    next_due_.wait_until(lock, due);
    has_watcher_ = false;
}

void TickPool::run_first(std::unique_lock<std::mutex>& lock) {
    PooledLoop& loop = *waiting_.begin()->second;
    waiting_.erase(waiting_.begin());
    ASSERT(!loop.runs_ && !loop.ends_);
    loop.runs_ = true;
    const bool others = !waiting_.empty() && !has_watcher_ && idle_ > 0;
    if (others && (loop.last_run_ > short_tick || waiting_.begin()->first <= Clock::now()))
        work_.notify_one();
    lock.unlock();
    const bool continues = loop.run_due();
    lock.lock();
    loop.runs_ = false;
    if (continues && !loop.ends_)
        insert(loop);  // this thread continues with the first one
    else
        ended_.notify_all();
}

}  // namespace jostle::server
