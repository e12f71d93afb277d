// SPDX-License-Identifier: MIT
//
// Somebody looks at a whole world, between two of its ticks and on its own thread: to export it.
// The one who asks waits; the world is held up for as long as the look takes, so looks copy and
// leave the rest to the asker. One at a time.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

#include "jostle/base/result.h"

namespace jostle::server {

class HostedWorld;

class BetweenTicksExecutor {
public:
    using Task = std::function<void(HostedWorld&)>;
    // A tick may take long; one that takes longer is hung.
    static constexpr auto timeout = std::chrono::seconds(5);

    // Any thread: returns when the visit is over. Errors: somebody else visits, the world ended or
    // does not come to a tick's end.
    Status run(const Task& task);

    // The world's thread, between two ticks.
    void run_pending(HostedWorld& world);
    // Any thread: the world ends.
    void close();

private:
    std::atomic<const Task*> waiting_{nullptr};
    std::mutex mutex_;
    std::condition_variable changed_;
    bool failed_ = false;  // the last visit
    bool closed_ = false;
};

}  // namespace jostle::server
