// SPDX-License-Identifier: MIT
//
// Records the ticks of a world on request, for profiling. Without a request a tick only reads a
// flag. One recording at a time, because each holds memory.
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

// The times of one tick.
struct TickProfile {
    std::uint32_t tick = 0;
    Clock::time_point due, begun, ended;
    Clock::time_point step_begun;  // after the inputs
    // Milliseconds per stage, in order of execution; all 0: the tick took no step.
    std::array<double, physics::stage_count> stage_ms{};
    int bodies_awake = 0, touching = 0, inputs = 0;
    std::uint32_t late_ticks = 0;  // skipped since the start of the world
};

class TickProfiler {
public:
    static constexpr std::size_t ticks_max = 4000;  // per recording: at least 30 s at 120 Hz

    // Any thread: records for `time` and returns the ticks. Returns earlier after ticks_max ticks
    // or at the end of the world. Errors: another request is recording (resource_exhausted), or the
    // world was closed (aborted).
    Result<std::vector<TickProfile>> record(Clock::duration time);

    // The tick thread.
    bool is_requested() const { return requested_.load(std::memory_order_relaxed); }
    void put(const TickProfile& tick);
    // Any thread: ends a recording; later ones fail.
    void close();

private:
    std::atomic<bool> requested_{false};
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<TickProfile> ticks_;
    bool recording_ = false, closed_ = false;
};

}  // namespace jostle::server
