// SPDX-License-Identifier: MIT
//
// The timer of a world: runs a function at a fixed rate on the threads of a TickPool and catches up
// after a delay, as TickClock decides. A world with nothing to do may rest: its ticks then run
// several at a time, until it is woken.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "server/util/clock.h"
#include "server/world/tick_clock.h"
#include "server/world/tick_pool.h"

namespace jostle::server {

class TickLoop : private PooledLoop {
public:
    struct Settings {
        double hz = 60;
        int catch_up_ticks_max = 4;  // ticks that run at once after a delay
        int rest_ticks = 1;          // ticks that run at once while the world rests
        double speed = 1;            // share of `hz` at which ticks begin
    };
    struct Tick {
        Clock::time_point due;
        std::uint32_t late_ticks = 0;  // skipped so far
        int following = 0;             // further ticks that run directly after this one
    };
    // Returns whether the world may rest; the result counts after the last of several ticks.
    using Run = std::function<bool(const Tick& tick)>;

    TickLoop() = default;
    ~TickLoop() override;  // after stop(), or without a start
    TickLoop(const TickLoop&) = delete;
    TickLoop& operator=(const TickLoop&) = delete;

    // The first tick is due one period after `epoch`. The loop ends when `stopped`, called before
    // each tick, returns true. An exception of a tick also ends it and is passed to `on_error` on
    // the thread.
    void start(std::shared_ptr<TickPool> pool, const Settings& settings, Clock::time_point epoch,
               Run run, std::function<bool()> stopped,
               std::function<void(const char* what)> on_error);
    // Any thread: ends the rest of the world, because it has work. Cheap if it does not rest.
    void wake();
    // From within a tick: the rate of the following ticks is this share of `hz`.
    void set_speed(double speed) {
        if (clock_) clock_->set_hz(speed * settings_.hz);
    }
    // Waits for the running tick; no other follows. Not from within a tick.
    void stop();

private:
    int rest_ticks_max() const;  // ticks that are not late at the end of a rest
    bool run_due() override;
    void end_rest() override;

    std::shared_ptr<TickPool> pool_;
    Settings settings_;
    std::optional<TickClock> clock_;
    Run run_;
    std::function<bool()> stopped_;
    std::function<void(const char* what)> on_error_;
    // Whoever sets one of them reads the other one afterwards, so that no call of wake() is lost.
    std::atomic<bool> rests_{false}, woken_{false};
};

}  // namespace jostle::server
