// SPDX-License-Identifier: MIT
//
// Ends the process when it has not ended by itself in time: whatever hangs, a supervisor is obeyed.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "server/util/clock.h"

namespace jostle::server {

class ShutdownWatchdog {
public:
    static constexpr int status = 3;

    // From now on.
    explicit ShutdownWatchdog(Clock::duration timeout);
    ~ShutdownWatchdog();  // in time

private:
    std::mutex mutex_;
    std::condition_variable ended_;
    bool done_ = false;
    std::thread thread_;
};

}  // namespace jostle::server
