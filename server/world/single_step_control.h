// SPDX-License-Identifier: MIT
//
// Single steps of a paused world, for debugging.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "jostle/base/result.h"
#include "server/util/clock.h"

namespace jostle::server {

class SingleStepControl {
public:
    // Any thread: lets a paused world take `steps` steps and waits until their frames are
    // published, or for `timeout`. Returns the number of published steps. Errors: another request
    // is stepping the world (resource_exhausted), or the world was closed (aborted).
    Result<int> step(int steps, Clock::duration timeout);

    // The tick thread of a paused world, in each tick: whether the world takes a step.
    bool begin_step();
    // After the frame of the tick was published.
    void end_tick();
    // Any thread: ends a waiting step() because the world resumed.
    void cancel();
    // Any thread: likewise because the world ends; later calls of step() fail.
    void close();

private:
    std::atomic<bool> requested_{false};
    std::mutex mutex_;
    std::condition_variable taken_;
    int allowed_ = 0;    // steps still to take
    int begun_ = 0;      // steps taken
    int published_ = 0;  // steps taken whose frames are published
    bool closed_ = false;
};

}  // namespace jostle::server
