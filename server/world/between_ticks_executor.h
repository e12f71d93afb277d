// SPDX-License-Identifier: MIT
//
// Runs a task on a world between two ticks, on the tick thread; a scene export is one. The caller
// waits for the task and the task delays the next tick, so tasks copy and the caller does the rest.
// One task at a time.
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
    // Longer than any tick of a world that does not hang.
    static constexpr auto timeout = std::chrono::seconds(5);

    // Any thread: returns after the task ran. Errors: another task waits, the world was closed, its
    // tick did not end in time, or the task ran out of memory.
    Status run(const Task& task);

    // The tick thread, between two ticks.
    void run_pending(HostedWorld& world);
    // Any thread: releases a waiting run() with an error; later calls fail at once.
    void close();

private:
    std::atomic<const Task*> waiting_{nullptr};
    std::mutex mutex_;
    std::condition_variable changed_;
    bool failed_ = false;  // the last task ran out of memory
    bool closed_ = false;
};

}  // namespace jostle::server
