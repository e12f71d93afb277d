// SPDX-License-Identifier: MIT
//
// The server's monotonic clock. Functions that depend on time take it as an argument, so that tests
// can supply their own.
#pragma once

#include <chrono>
#include <cstdint>

namespace jostle::server {

using Clock = std::chrono::steady_clock;

// A thread that polls every few tens of milliseconds and misses polls for this long was stalled,
// and with it the process or the machine. Peers and worlds are then not blamed for the delay.
inline constexpr auto process_stall_min = std::chrono::milliseconds(500);

// Wire time: microseconds of the server's monotonic clock, plus 2^50 us (35 years). The machine's
// clock may have started after the first tick of a restored world; the offset keeps that tick's
// time positive.
inline std::uint64_t to_us(Clock::time_point t) {
    constexpr std::int64_t earlier = std::int64_t{1} << 50;
    return static_cast<std::uint64_t>(
        earlier +
        std::chrono::duration_cast<std::chrono::microseconds>(t.time_since_epoch()).count());
}

inline double to_ms(Clock::duration d) {
    return std::chrono::duration<double, std::milli>(d).count();
}

inline Clock::duration from_seconds(double seconds) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace jostle::server
