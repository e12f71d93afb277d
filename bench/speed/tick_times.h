// SPDX-License-Identifier: MIT
//
// Durations and drops of the ticks of a world, read from the trace that a server's profile contains
// (jostlectl profile, /debug/profile).
#pragma once

#include <string>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::bench {

struct TickTimes {
    std::vector<double> ms;    // of each tick: inputs, step, frame and replies
    int late = 0;              // ticks dropped between the first and the last of these
    double begun_late_ms = 0;  // largest delay from the due time of a tick to its start
};

// Starts at the first tick with a step: a paused world takes none.
Result<TickTimes> read_tick_times(const std::string& trace);

}  // namespace jostle::bench
