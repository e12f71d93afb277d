// SPDX-License-Identifier: MIT
//
// Watches the ticks of all worlds on a thread of its own. It interrupts ticks that use too much
// processor time and pauses their worlds for a while, reports ticks that hang, adds threads to the
// pool while such ticks keep theirs, and restarts worlds that an error ended. A world that hangs
// concerns its own clients only: the process is healthy as long as this thread runs.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "server/world/world_directory.h"

namespace jostle::server {

class TickWatchdog {
public:
    struct Settings {
        // Processor time of the tick thread in one tick, after which the tick is interrupted. A
        // busy machine delays a tick but does not add to it.
        Clock::duration tick_cpu_max = std::chrono::seconds(2);
        // Elapsed time after which a tick is reported as hung: its thread waits, for example for a
        // disk, or gets no processor time.
        Clock::duration hung_after = std::chrono::seconds(5);
    };
    // `worlds` must outlive this object.
    TickWatchdog(WorldDirectory& worlds, Settings settings);
    ~TickWatchdog();

    // Any thread: false if the watchdog thread does not run, so the process does not either.
    bool is_alive(Clock::time_point now) const;

    // One round of the thread, which runs every 100 ms. Public for tests.
    void check(Clock::time_point now);

private:
    void run();
    // Returns whether the running tick hangs.
    bool check_tick(WorldHost& world, Clock::time_point now, bool stalled);

    WorldDirectory& worlds_;
    const Settings settings_;
    std::atomic<Clock::rep> checked_at_;
    std::set<std::string> hung_;  // ids of worlds; a hang is reported once
    std::mutex mutex_;
    std::condition_variable wake_;
    bool stopping_ = false;
    std::thread thread_;
};

}  // namespace jostle::server
