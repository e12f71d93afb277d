// SPDX-License-Identifier: MIT
//
// Threads that do what takes long, and a bounded queue before them: who finds it full is told at
// once, so that nobody waits for what will never be done in time. Any thread may add.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace jostle::server {

class WorkPool {
public:
    // `niceness`: how far its threads stand back behind those that tick and send (setpriority).
    WorkPool(int threads, std::size_t queue_max, int niceness);
    ~WorkPool();

    // False: the queue is full or the pool is stopping; the work is not done.
    bool add(std::function<void()> work);
    // Does what is queued, then ends the threads.
    void stop();

private:
    void run(int niceness);

    const std::size_t queue_max_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> queue_;
    bool stopping_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace jostle::server
