// SPDX-License-Identifier: MIT
//
// Wall-clock time, for data that must agree with other machines: tokens, certificates, log lines.
// It can be set and may jump; timeouts and intervals use clock.h.
#pragma once
#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>

#include <chrono>
#include <string>

#include "server/util/clock.h"

namespace jostle::server {

using WallTime = std::chrono::system_clock::time_point;

// A WallTime ends in 2262; external times are compared with this limit first.
inline constexpr std::int64_t wall_seconds_max = 9'000'000'000;  // in 2255

// "2026-09-21T14:13:20.007Z"
inline std::string rfc3339(WallTime time) {
    const auto ms = std::chrono::floor<std::chrono::milliseconds>(time);
    const auto s = std::chrono::floor<std::chrono::seconds>(ms);
    return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(s)), (ms - s).count());
}

// One point in time on both clocks. Tokens and audit lines use wall-clock time; quotas and tickets
// use the monotonic clock, which cannot be set. Callers of the authorizer use the default; tests
// supply their own.
struct ClockPair {
    Clock::time_point steady;
    WallTime wall;

    static ClockPair now() { return {Clock::now(), std::chrono::system_clock::now()}; }
};

}  // namespace jostle::server
