// SPDX-License-Identifier: MIT
//
// How long the ticks of a world took, and which were given up: read from the trace that a
// server's profile is (jostlectl profile, /debug/profile).
#pragma once

#include <string>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::bench {

struct TickTimes {
    std::vector<double> ms;    // of each tick: inputs, step, frame and answers
    int late = 0;              // given up between the first and the last of these
    double begun_late_ms = 0;  // how long after its due time a tick began, at worst
};

// From the first tick on that took a step: a world that is paused at first takes none.
Result<TickTimes> read_tick_times(const std::string& trace);

}  // namespace jostle::bench
