// SPDX-License-Identifier: MIT
//
// What the clients of one thread saw since the measurement began. Threads' figures are merged when
// all are done.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "jostle/client/clock_sync.h"
#include "tools/load/histogram.h"

namespace jostle::load {

using client::Clock;

struct LoadMetrics {
    std::uint64_t messages = 0, bytes = 0;  // received, of all kinds
    std::uint64_t snapshots = 0, snapshot_bytes = 0;
    std::uint64_t decoded = 0;  // of the snapshots: compared with their CRC
    std::uint64_t inputs_sent = 0, inputs_applied = 0;
    // Streams that ended, messages that were none, inputs of good form that were refused; since the
    // beginning.
    std::uint64_t errors = 0;
    std::string last_error;
    double seconds = 0;      // that were measured
    double cpu_seconds = 0;  // of the thread

    Histogram age;           // of a snapshot: from when its tick was due to when it was read
    Histogram gap;           // from one snapshot to the next of the same client
    Histogram result_delay;  // from when an input was sent to when its result was read
    Histogram effect_delay;  // likewise, to the first snapshot of the tick that applied it
    std::vector<Histogram> age_windows;  // age, in pieces of window_s

    static constexpr int window_s = 10;

    void add_age(std::int64_t us, Clock::time_point now);
    void add_error(const std::string& what);
    // What came before is not measured; errors stay.
    void begin(Clock::time_point now);
    // No more is added.
    void end(Clock::time_point now);
    void merge(const LoadMetrics& other);

private:
    Clock::time_point start_ = Clock::now();
};

}  // namespace jostle::load
