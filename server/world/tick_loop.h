// SPDX-License-Identifier: MIT
//
// The thread of a world and its timer: calls a function at a fixed rate and catches up after a
// delay, as TickClock decides.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <thread>

#include "server/util/clock.h"

namespace jostle::server {

class TickLoop {
public:
    struct Settings {
        double hz = 60;
        int catch_up_ticks_max = 4;  // ticks that run at once after a delay
    };
    // The time at which the tick was due, and the number of ticks skipped so far.
    using Tick = std::function<void(Clock::time_point due, std::uint32_t late_ticks)>;

    TickLoop();
    ~TickLoop();  // after stop(), or without a start

    // Starts the thread; the first tick is due one period after `epoch`. The loop ends when
    // `stopped`, called before each tick, returns true. An exception of a tick also ends it and is
    // passed to `on_error` on the thread.
    void start(const Settings& settings, Clock::time_point epoch, Tick tick,
               std::function<bool()> stopped, std::function<void(const char* what)> on_error);
    // Waits for the running tick; the thread ends.
    void stop();

private:
    void run(const Settings& settings, Clock::time_point epoch);

    struct Timer;  // hides Asio from this header
    std::unique_ptr<Timer> timer_;
    Tick tick_;
    std::function<bool()> stopped_;
    std::function<void(const char* what)> on_error_;
    std::thread thread_;
};

}  // namespace jostle::server
