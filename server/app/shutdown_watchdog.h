// SPDX-License-Identifier: MIT
//
// Ends the process if the shutdown takes longer than a timeout, so that a hanging thread cannot
// block a supervisor.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "server/util/clock.h"

namespace jostle::server {

class ShutdownWatchdog {
public:
    static constexpr int exit_status = 3;

    // The timeout starts now.
    explicit ShutdownWatchdog(Clock::duration timeout);
    ~ShutdownWatchdog();  // cancels it

private:
    std::mutex mutex_;
    std::condition_variable ended_;
    bool done_ = false;
    std::thread thread_;
};

}  // namespace jostle::server
