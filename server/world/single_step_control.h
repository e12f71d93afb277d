// SPDX-License-Identifier: MIT
//
// Steps that a paused world takes because somebody allows them: to look at what happens, one by
// one.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "jostle/base/result.h"
#include "server/util/clock.h"

namespace jostle::server {

class SingleStepControl {
public:
    // Any thread: lets a paused world take so many steps, and waits until frames show them, or for
    // `patience`. How many were taken. Errors: somebody else steps it, or the world ended.
    Result<int> step(int steps, Clock::duration timeout);

    // The thread of a paused world, in each tick: whether it takes a step all the same; and when
    // the tick's frame is out.
    bool begin_step();
    void end_tick();
    // Any thread: the world ends or goes on by itself, and nobody waits for it any longer.
    void cancel();
    void close();

private:
    std::atomic<bool> requested_{false};
    std::mutex mutex_;
    std::condition_variable taken_;
    int allowed_ = 0;    // that may still be taken
    int published_ = 0;  // of those that were: whose frames are out
    int begun_ = 0;      // ... or not yet
    bool closed_ = false;
};

}  // namespace jostle::server
