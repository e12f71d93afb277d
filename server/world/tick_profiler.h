// SPDX-License-Identifier: MIT
//
// Records the ticks of a world for somebody who asks where its time goes. While nobody does, a tick
// pays one look at a flag. One recording at a time: it holds memory and is about one machine.
#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/physics/profile.h"
#include "server/util/clock.h"

namespace jostle::server {

// One tick, as its thread saw it.
struct TickProfile {
    std::uint32_t tick = 0;
    Clock::time_point due, begun, ended;
    Clock::time_point step_begun;  // after the inputs
    // Milliseconds, in the order in which they ran; all 0: the tick took no step.
    std::array<double, physics::stage_count> stage_ms{};
    int bodies_awake = 0, touching = 0, inputs = 0;
    std::uint32_t late_ticks = 0;  // that were given up since the world began
};

class TickProfiler {
public:
    static constexpr std::size_t ticks_max = 4000;  // of one recording: 30 s at 120 Hz and some

    // Any thread: waits for so long and gives what was recorded; less when ticks_max were or the
    // world ended. Errors: somebody else records (resource_exhausted).
    Result<std::vector<TickProfile>> record(Clock::duration time);

    // The world's thread.
    bool is_requested() const { return requested_.load(std::memory_order_relaxed); }
    void put(const TickProfile& tick);
    // Any thread: nothing will come any more.
    void close();

private:
    std::atomic<bool> requested_{false};
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<TickProfile> ticks_;
    bool recording_ = false, closed_ = false;
};

}  // namespace jostle::server
