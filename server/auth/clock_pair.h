// SPDX-License-Identifier: MIT
//
// One point in time on both clocks. Tokens and audit lines use wall-clock time; quotas and tickets
// use the monotonic clock, which cannot be set. Callers of the authorizer use the default; tests
// supply their own.
#pragma once

#include "server/util/clock.h"
#include "server/util/wall_time.h"

namespace jostle::server {

struct ClockPair {
    Clock::time_point steady;
    WallTime wall;

    static ClockPair now() { return {Clock::now(), std::chrono::system_clock::now()}; }
};

}  // namespace jostle::server
