// SPDX-License-Identifier: MIT
//
// Sees to it that no world holds up the others or hides that it hangs: a step that takes too long
// is interrupted and its world paused, a world that an error ended is started anew, and health asks
// here whether every world still ticks. Has a thread of its own.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "server/world/world_directory.h"

namespace jostle::server {

class TickWatchdog {
public:
    // Both limits are of one tick. The directory outlives the watch.
    struct Settings {
        Clock::duration step_max = std::chrono::seconds(2);  // then it is interrupted
        Clock::duration hung_after = std::chrono::milliseconds(1500);
    };
    TickWatchdog(WorldDirectory& worlds, Settings settings);
    ~TickWatchdog();

    // Any thread: false while a tick runs for too long. Of a watch that itself does not get to
    // look, as well.
    bool all_worlds_tick(Clock::time_point now) const;

    // What the thread does every now and then.
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
