// SPDX-License-Identifier: MIT
//
// Measures the ticks of a world: counts each tick in the metrics and records it while a profile is
// requested. The tick thread calls it at the start and the end of a tick;
// tests/server/world/tick_metrics_test.cpp measures its cost.
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
    // Null metrics: only recording works.
    TickMetrics(Metrics* metrics, const std::string& world);

    // Any thread.
    Result<std::vector<TickProfile>> record(Clock::duration time) { return profiler_.record(time); }
    void close() { profiler_.close(); }
    WorldMetrics* metrics() { return metrics_.get(); }  // null: no metrics
    void count_pause(PauseCause cause) {
        if (metrics_) metrics_->count_pause(cause);
    }
    void set_hung(bool hung) {
        if (metrics_) metrics_->set_hung(hung);
    }

    // Whether a profile is requested.
    bool is_recording() const { return profiler_.is_requested(); }

    // The tick thread: a tick of a resting world.
    void count_resting_tick() {
        if (metrics_) metrics_->count_resting_tick();
    }
    // The tick thread, in this order.
    void begin_tick(Clock::time_point now) { begun_ = now; }
    void begin_step() {
        if (profiler_.is_requested()) step_begun_ = Clock::now();
    }
    // `profile`: of the step; null: the tick took no step.
    void end_tick(const Frame& frame, const physics::StepProfile* profile, std::size_t inputs);

private:
    void profile_tick(const Frame& frame, const physics::StepProfile* profile, std::size_t inputs,
                      Clock::time_point now);

    const std::unique_ptr<WorldMetrics> metrics_;
    TickProfiler profiler_;
    Clock::time_point begun_{}, step_begun_{};
};

}  // namespace jostle::server
