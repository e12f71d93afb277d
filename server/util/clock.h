// SPDX-License-Identifier: MIT
//
// The server's one clock: monotonic. What depends on time takes the time as an argument, so that
// tests make their own.
#pragma once

#include <chrono>
#include <cstdint>

namespace jostle::server {

using Clock = std::chrono::steady_clock;

// A thread that looks every few hundredths of a second and has not looked for so long stood still,
// and with it the process or the machine: nobody else was late.
inline constexpr auto process_stall_min = std::chrono::milliseconds(500);

// On the wire: microseconds of the server's monotonic clock. That of the machine may have begun
// after the first tick of a world that was kept: on the wire it began 35 years earlier.
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
