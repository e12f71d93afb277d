// SPDX-License-Identifier: MIT
//
// The series of one world, labelled with its name. They are there for as long as somebody holds
// them, so that worlds that come and go leave nothing behind. A name that is used again while its
// old world still ends shares them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "server/metrics/metrics.h"

namespace jostle::server {

// What one tick of a world was like.
struct TickSample {
    double seconds = 0;                     // the whole tick
    std::span<const double> stage_ms = {};  // of the step, by stage; empty: it took none
    std::size_t bodies = 0, awake = 0;
    std::size_t queued = 0;        // inputs that waited when it began
    std::uint32_t late_ticks = 0;  // given up since the world began
};

class WorldMetrics {
public:
    WorldMetrics(Metrics& metrics, const std::string& world);
    ~WorldMetrics();
    WorldMetrics(const WorldMetrics&) = delete;
    WorldMetrics& operator=(const WorldMetrics&) = delete;

    // The world's thread.
    void count_tick(const TickSample& tick);
    // Any thread.
    prometheus::Gauge& clients() { return *series_.clients; }

private:
    // Of one name; several holders may share them.
    struct Series {
        prometheus::Histogram* tick_seconds;
        prometheus::Counter* late_ticks;
        prometheus::Gauge *bodies, *awake_bodies, *queue_depth, *paused, *clients;
    };
    Series acquire_series();

    Metrics& metrics_;
    const std::string world_;
    const Series series_;
    std::uint32_t late_counted_ = 0;
};

}  // namespace jostle::server
