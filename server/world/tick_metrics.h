// SPDX-License-Identifier: MIT
//
// What is seen from outside of a world's ticks: each is counted for the metrics, and recorded for
// whoever profiles. The world's thread calls it at the ends of a tick; what that costs is measured
// in tests/server/world/tick_metrics_test.cpp.
#pragma once

#include <memory>
#include <string>

#include "server/metrics/world_metrics.h"
#include "server/util/clock.h"
#include "server/world/frame.h"
#include "server/world/tick_profiler.h"

namespace jostle::server {

class TickMetrics {
public:
    // Without metrics nothing is counted; recording works all the same.
    TickMetrics(Metrics* metrics, const std::string& world);

    // Any thread.
    Result<std::vector<TickProfile>> record(Clock::duration time) { return profiler_.record(time); }
    void close() { profiler_.close(); }
    WorldMetrics* metrics() { return metrics_.get(); }  // null: nobody counts

    // The world's thread, in this order.
    void begin_tick(Clock::time_point now) { begun_ = now; }
    void begin_step() {
        if (profiler_.is_requested()) step_begun_ = Clock::now();
    }
    // `profile`: of the step; null when the tick took none.
    void end_tick(const Frame& frame, const physics::StepProfile* profile, std::size_t inputs);

private:
    void profile_tick(const Frame& frame, const physics::StepProfile* profile, std::size_t inputs,
                      Clock::time_point now);

    const std::unique_ptr<WorldMetrics> metrics_;
    TickProfiler profiler_;
    Clock::time_point begun_{}, step_begun_{};
};

}  // namespace jostle::server
