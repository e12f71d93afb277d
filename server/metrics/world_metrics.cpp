// SPDX-License-Identifier: MIT
#include "server/metrics/world_metrics.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// Seconds. A tick of a world with a few bodies takes 30 us; 16.7 ms is one period at 60 Hz, so
// ticks above it make the world late.
const prometheus::Histogram::BucketBoundaries tick_buckets = {
    0.00005, 0.0001, 0.00025, 0.0005, 0.001, 0.002, 0.004, 0.008, 0.0167, 0.0334, 0.1, 0.5, 2};

}  // namespace

WorldMetrics::WorldMetrics(Metrics& metrics, const std::string& world)
    : metrics_(metrics), world_(world), series_(acquire_series()) {}

// Add() returns the existing series if there is one.
WorldMetrics::Series WorldMetrics::acquire_series() {
    const std::lock_guard lock(metrics_.world_holders.mutex);
    metrics_.world_holders.count[world_]++;
    const prometheus::Labels labels{{"world", world_}};
    const auto pauses = [&](PauseCause cause) -> prometheus::Counter& {
        const std::string name(names_of(cause)[static_cast<std::size_t>(cause)]);
        return metrics_.pauses.Add({{"world", world_}, {"cause", name}});
    };
    return {.tick_seconds = &metrics_.tick_seconds.Add(labels, tick_buckets),
            .tick_lateness = &metrics_.tick_lateness.Add(labels, tick_buckets),
            .late_ticks = &metrics_.late_ticks.Add(labels),
            .pauses = {&pauses(PauseCause::request), &pauses(PauseCause::overload)},
            .bodies = &metrics_.bodies.Add(labels),
            .awake_bodies = &metrics_.awake_bodies.Add(labels),
            .queue_depth = &metrics_.queue_depth.Add(labels),
            .paused = &metrics_.paused.Add(labels),
            .hung = &metrics_.hung.Add(labels),
            .time_scale = &metrics_.time_scale.Add(labels),
            .clients = &metrics_.clients.Add(labels)};
}

WorldMetrics::~WorldMetrics() {
    const std::lock_guard lock(metrics_.world_holders.mutex);
    const auto at = metrics_.world_holders.count.find(world_);
    ASSERT(at != metrics_.world_holders.count.end() && at->second > 0);
    if (--at->second > 0) return;
    metrics_.world_holders.count.erase(at);
    metrics_.tick_seconds.Remove(series_.tick_seconds);
    metrics_.tick_lateness.Remove(series_.tick_lateness);
    metrics_.late_ticks.Remove(series_.late_ticks);
    metrics_.bodies.Remove(series_.bodies);
    metrics_.awake_bodies.Remove(series_.awake_bodies);
    metrics_.queue_depth.Remove(series_.queue_depth);
    for (prometheus::Counter* const counter : series_.pauses) metrics_.pauses.Remove(counter);
    metrics_.paused.Remove(series_.paused);
    metrics_.hung.Remove(series_.hung);
    metrics_.time_scale.Remove(series_.time_scale);
    metrics_.clients.Remove(series_.clients);
}

void WorldMetrics::count_tick(const TickSample& tick) {
    ASSERT(tick.seconds >= 0 && tick.lateness_seconds >= 0);
    series_.tick_seconds->Observe(tick.seconds);
    series_.tick_lateness->Observe(tick.lateness_seconds);
    const std::size_t stages = std::min(tick.stage_ms.size(), metrics_.stages.size());
    for (std::size_t i = 0; i < stages; i++)
        if (tick.stage_ms[i] > 0) metrics_.stages[i]->Increment(tick.stage_ms[i] / 1000);
    series_.bodies->Set(static_cast<double>(tick.bodies));
    series_.awake_bodies->Set(static_cast<double>(tick.awake));
    series_.queue_depth->Set(static_cast<double>(tick.queued));
    series_.paused->Set(tick.stage_ms.empty() ? 1 : 0);
    series_.time_scale->Set(tick.time_scale);
    if (tick.late_ticks != late_counted_) {
        ASSERT(tick.late_ticks > late_counted_);
        series_.late_ticks->Increment(tick.late_ticks - late_counted_);
        late_counted_ = tick.late_ticks;
    }
}

}  // namespace jostle::server
