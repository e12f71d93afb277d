// SPDX-License-Identifier: MIT
//
// One moment on both clocks: tokens and audit lines go by the wall's, quotas and tickets by the
// monotonic one, which nobody can set. Callers of the gate leave it out; tests make their own.
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
