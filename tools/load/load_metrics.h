// SPDX-License-Identifier: MIT
//
// Measurements of the clients of one thread since the measurement started. The metrics of all
// threads are merged at the end.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jostle/client/clock_sync.h"
#include "tools/load/histogram.h"

namespace jostle::load {

using client::Clock;

struct LoadMetrics {
    std::uint64_t messages = 0, bytes = 0;  // received, of all kinds
    std::uint64_t snapshots = 0, snapshot_bytes = 0;
    std::uint64_t decoded = 0;  // snapshots that were decoded and verified with their CRC
    std::uint64_t inputs_sent = 0, inputs_applied = 0;
    // Streams that ended, malformed messages and rejected valid inputs, since the start of the run.
    std::uint64_t errors = 0;
    std::string last_error;
    // Rendered frames of decoding passive clients, and those that were frozen or jumped.
    std::uint64_t rendered = 0, frozen = 0;
    std::uint64_t user_messages = 0, messages_missed = 0;  // received, and dropped by the server
    double seconds = 0;                                    // duration of the measurement
    double cpu_seconds = 0;                                // of the thread

    Histogram age;           // of a snapshot: from the due time of its tick until it was read
    Histogram gap;           // between successive snapshots of a client
    Histogram result_delay;  // from sending an input until its result was read
    // from sending an input until the first snapshot of the tick that applied it was read
    Histogram effect_delay;
    Histogram message_delay;             // from sending a user message until a client read it
    std::vector<Histogram> age_windows;  // age, in intervals of window_s

    static constexpr int window_s = 10;

    void add_age(std::int64_t us, Clock::time_point now);
    void add_error(const std::string& what);
    // Starts the measurement: resets all metrics except errors.
    void begin(Clock::time_point now);
    // Ends the measurement.
    void end(Clock::time_point now);
    void merge(const LoadMetrics& other);

private:
    Clock::time_point start_ = Clock::now();
};

// Returns the process that listens on the port of HOST:PORT if HOST is this machine.
std::optional<int> find_listener(const std::string& target);
// CPU time of the process so far, s.
std::optional<double> cpu_seconds(int pid);

}  // namespace jostle::load
