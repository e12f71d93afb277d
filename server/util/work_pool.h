// SPDX-License-Identifier: MIT
//
// A thread pool for slow work with a bounded queue. A full queue rejects work at once, so that no
// caller waits for work that would not finish in time. Any thread may add work.
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
    // `niceness`: priority offset of its threads relative to the threads that tick and send
    // (setpriority).
    WorkPool(int threads, std::size_t queue_max, int niceness);
    ~WorkPool();

    // Returns false if the queue is full or the pool is stopping; the work is then not run.
    bool add(std::function<void()> work);
    // Runs the queued work, then joins the threads.
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
