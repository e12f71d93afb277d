// SPDX-License-Identifier: MIT
#include "server/world/tick_metrics.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

TickMetrics::TickMetrics(Metrics* metrics, const std::string& world)
    : metrics_(metrics ? std::make_unique<WorldMetrics>(*metrics, world) : nullptr) {}

void TickMetrics::end_tick(const Frame& frame, const physics::StepProfile* profile,
                           std::size_t inputs) {
    const Clock::time_point now = Clock::now();
    ASSERT(now >= begun_);
    if (metrics_) {
        const auto seconds = [](Clock::duration time) {
            return std::chrono::duration<double>(time).count();
        };
        TickSample count{.seconds = seconds(now - begun_),
                         .lateness_seconds = std::max(0.0, seconds(begun_ - frame.due)),
                         .bodies = frame.entities.size(),
                         .awake = static_cast<std::size_t>(frame.awake),
                         .queued = inputs,
                         .late_ticks = frame.late_ticks,
                         .time_scale = frame.time_scale};
        if (profile) count.stage_ms = profile->stage_ms;
        metrics_->count_tick(count);
    }
    if (profiler_.is_requested()) profile_tick(frame, profile, inputs, now);
}

void TickMetrics::profile_tick(const Frame& frame, const physics::StepProfile* profile,
                               std::size_t inputs, Clock::time_point now) {
    TickProfile record{.tick = frame.tick,
                       .due = frame.due,
                       .begun = begun_,
                       .ended = now,
                       .step_begun = step_begun_,
                       .bodies_awake = frame.awake,
                       .touching = frame.contacts,
                       .inputs = static_cast<int>(inputs),
                       .late_ticks = frame.late_ticks};
    // The recording started after the step of this tick began.
    if (step_begun_ < begun_) return;
    if (profile) record.stage_ms = profile->stage_ms;
    profiler_.put(record);
}

}  // namespace jostle::server
