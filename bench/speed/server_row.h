// SPDX-License-Identifier: MIT
//
// One row of the server table: a scene that jostle-server hosts for connected clients, the times of
// its ticks, the late ticks, and the data that the clients received.
#pragma once
#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

#include "bench/speed/speed_scenes.h"
#include "jostle/base/result.h"

namespace jostle::bench {

struct ServerRow {
    std::string scene, name;  // letter and name
    int threads = 1;          // of the world's step
    int clients = 0;
    double seconds = 0;                 // duration
    std::optional<std::string> failed;  // the reason why there are no values

    int bodies = 0;
    double hz = 0;
    int ticks = 0;              // that ran
    int late_ticks = 0;         // that never ran: the world was late by more than it may catch up
    double late_share = 0;      // of all due ticks
    int ticks_over_period = 0;  // that took longer than the tick period
    double ms_mean = 0, ms_p99 = 0, ms_worst = 0;  // of a tick: inputs, step, frame, replies
    double begun_late_ms_worst = 0;                // from the due time of a tick to its start
    // "holds": each tick took less than a period. "catches up": some took longer, but none was
    // dropped. "late": some were dropped.
    std::string verdict;

    // As reported by jostle-load: decoded snapshots and their age when decoded.
    int connected = 0;  // at the end
    double snapshots_per_second_per_client = 0, kbit_per_second_per_client = 0;
    double age_ms_p50 = 0, age_ms_p99 = 0;
    int errors = 0;
    std::optional<double> server_cpu_percent;  // of one core
};

// From ticks, late_ticks and ticks_over_period.
const char* verdict_of(const ServerRow& row);

nlohmann::ordered_json to_json(const ServerRow& row);

// Measures one row of the server table: starts jostle-server, jostle-load and jostlectl, which must
// be in the directory of this program, and collects their reports.
struct ServerRequest {
    const SpeedScene* scene = nullptr;
    int threads = 1;  // of the world's step
    int clients = 20;
    double seconds = 10;  // 1 to 30: the limit of a server's recording
    std::string script;   // script file for jostle-load; empty: clients push bodies
};

ServerRow measure_server_row(const ServerRequest& request);

// Durations and drops of the ticks of a world, read from the trace that a server's profile contains
// (jostlectl profile, /debug/profile).

struct TickTimes {
    std::vector<double> ms;    // of each tick: inputs, step, frame and replies
    int late = 0;              // ticks dropped between the first and the last of these
    double begun_late_ms = 0;  // largest delay from the due time of a tick to its start
};

// Starts at the first tick with a step: a paused world takes none.
Result<TickTimes> read_tick_times(const std::string& trace);

}  // namespace jostle::bench
