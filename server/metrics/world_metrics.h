// SPDX-License-Identifier: MIT
//
// The series of one world, labelled with its name. They exist as long as they have a holder, so
// that deleted worlds leave no series behind. A new world that reuses a name while the old world
// still ends shares them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "server/metrics/metrics.h"

namespace jostle::server {

// The measurements of one tick of a world.
struct TickSample {
    double seconds = 0;                     // the whole tick
    double lateness_seconds = 0;            // from when it was due until it began
    std::span<const double> stage_ms = {};  // by stage of the step; empty: no step
    std::size_t bodies = 0, awake = 0;
    std::size_t queued = 0;        // inputs queued when the tick began
    std::uint32_t late_ticks = 0;  // skipped since the world started
    double time_scale = 1;         // simulated by elapsed time
};

class WorldMetrics {
public:
    WorldMetrics(Metrics& metrics, const std::string& world);
    ~WorldMetrics();
    WorldMetrics(const WorldMetrics&) = delete;
    WorldMetrics& operator=(const WorldMetrics&) = delete;

    // Called by the world's thread.
    void count_tick(const TickSample& tick);
    // A tick in which nothing happened. Changes the number of ticks only.
    void count_resting_tick() { series_.tick_seconds->Observe(0); }
    // Any thread.
    void count_pause(PauseCause cause) {
        series_.pauses[static_cast<std::size_t>(cause)]->Increment();
    }
    // `hung`: a tick of the world does not end.
    void set_hung(bool hung) { series_.hung->Set(hung ? 1 : 0); }
    prometheus::Gauge& clients() { return *series_.clients; }

private:
    // The series of one name; several holders may share them.
    struct Series {
        prometheus::Histogram* tick_seconds;
        prometheus::Histogram* tick_lateness;
        prometheus::Counter* late_ticks;
        std::array<prometheus::Counter*, names_of(PauseCause{}).size()> pauses;
        prometheus::Gauge *bodies, *awake_bodies, *queue_depth, *paused, *hung, *time_scale,
            *clients;
    };
    Series acquire_series();

    Metrics& metrics_;
    const std::string world_;
    const Series series_;
    std::uint32_t late_counted_ = 0;
};

}  // namespace jostle::server
