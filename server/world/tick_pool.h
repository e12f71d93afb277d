// SPDX-License-Identifier: MIT
//
// The threads that run the ticks of all worlds (world/tick_loop.h). Each loop runs on one thread at
// a time, and the loop that is due first runs first. A thread continues with the next loop if it is
// due when a short tick ends; long ticks run side by side. Idle threads cost nothing: one waits for
// the next due time, the others for work.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "server/util/clock.h"

namespace jostle::server {

// A loop as its pool runs it.
class PooledLoop {
public:
    virtual ~PooledLoop() = default;

protected:
    PooledLoop() = default;

    // Owned by the pool, under its lock, or by the thread that runs the loop.
    Clock::time_point wake_at_{};
    Clock::duration last_run_{};
    bool runs_ = false, ends_ = false;

private:
    friend class TickPool;

    virtual bool run_due() = 0;   // false: the loop has ended
    virtual void end_rest() = 0;  // under the lock of the pool
};

class TickPool {
public:
    // `threads`: at least 1.
    explicit TickPool(int threads);
    ~TickPool();  // all loops have ended

    // One thread per processor, but at least two, so that one long tick delays no other world.
    static std::shared_ptr<TickPool> for_processors();

    // Wakes or adds a thread if a loop has waited for more than 50 ms: a world that hangs keeps its
    // thread. Call it periodically.
    void add_thread_if_stuck(Clock::time_point now);
    std::size_t threads() const;

    // Any thread, for loops.
    void add(PooledLoop& loop);
    // Waits for the running tick of the loop; it does not run again.
    void remove(PooledLoop& loop);
    // The next tick of a resting loop runs as soon as it is due.
    void wake(PooledLoop& loop);

private:
    void start_thread();  // under the lock, as the following functions
    void work();
    void run_first(std::unique_lock<std::mutex>& lock);
    void wait_for_work(std::unique_lock<std::mutex>& lock);
    void insert(PooledLoop& loop);

    mutable std::mutex mutex_;
    std::condition_variable next_due_, work_, ended_;
    std::set<std::pair<Clock::time_point, PooledLoop*>> waiting_;  // by due time
    std::vector<std::thread> threads_;
    int idle_ = 0;              // threads that wait for work_
    bool has_watcher_ = false;  // a thread waits for next_due_
    bool stopping_ = false;
};

}  // namespace jostle::server
