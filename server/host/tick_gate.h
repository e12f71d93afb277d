// SPDX-License-Identifier: MIT
//
// Whether a world's time passes. A paused world goes on ticking: it takes inputs, answers and
// publishes frames, so clients stay and leavers leave; it only takes no step, but for those that
// somebody allows.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>

#include "base/clock.h"
#include "jostle/base/result.h"

namespace jostle::server {

class TickGate {
public:
    // Any thread. Going on forgets the steps that were allowed and not taken yet.
    void set_paused(bool paused);
    bool paused() const { return paused_.load(std::memory_order_relaxed); }

    // Any thread: lets a paused world take so many steps, and waits until frames show them, or for
    // `patience`. The number that is still to be taken then. Errors: the world is not paused, or
    // somebody else steps it.
    Result<int> take_steps(int steps, Clock::duration patience);

    // The world's thread, at both ends of a tick: whether it takes a step, and that its frame is
    // out.
    bool begin_tick();
    void end_tick();
    // Any thread: the world ends, and nobody waits for it any longer.
    void close();

private:
    std::atomic<bool> paused_{false};
    std::mutex mutex_;
    std::condition_variable taken_;
    int allowed_ = 0;  // steps that may be taken
    int untold_ = 0;   // steps whose frames are not out yet
    bool stepping_ = false, closed_ = false;
};

}  // namespace jostle::server
