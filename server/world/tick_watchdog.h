// SPDX-License-Identifier: MIT
//
// Watches the ticks of all worlds on a thread of its own. It interrupts steps that take too long
// and pauses their worlds, restarts worlds that an error ended, and reports to the health check
// whether every world ticks.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "server/world/world_directory.h"

namespace jostle::server {

class TickWatchdog {
public:
    // Times since the start of a tick.
    struct Settings {
        Clock::duration step_max = std::chrono::seconds(2);            // interrupt the step
        Clock::duration hung_after = std::chrono::milliseconds(1500);  // report a hang
    };
    // `worlds` must outlive this object.
    TickWatchdog(WorldDirectory& worlds, Settings settings);
    ~TickWatchdog();

    // Any thread: false while a tick hangs, or if the watchdog thread itself does not run.
    bool all_worlds_tick(Clock::time_point now) const;

    // One round of the thread, which runs every 100 ms. Public for tests.
    void check(Clock::time_point now);

private:
    void run();

    WorldDirectory& worlds_;
    const Settings settings_;
    std::atomic<Clock::rep> checked_at_;
    std::atomic<bool> hung_{false};
    std::mutex mutex_;
    std::condition_variable wake_;
    bool stopping_ = false;
    std::thread thread_;
};

}  // namespace jostle::server
