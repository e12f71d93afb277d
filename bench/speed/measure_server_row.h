// SPDX-License-Identifier: MIT
//
// Measures one row of the server table: starts jostle-server, jostle-load and jostlectl, which must
// be in the directory of this program, and collects their reports.
#pragma once

#include <string>
#include <vector>

#include "bench/speed/server_row.h"
#include "bench/speed/speed_scenes.h"
#include "jostle/base/result.h"

namespace jostle::bench {

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
