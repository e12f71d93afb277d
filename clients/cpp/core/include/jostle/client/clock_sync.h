// SPDX-License-Identifier: MIT
//
// Estimates the server's clock from the round trips of pings. The shortest round trip of the last
// 30 s is the most accurate: the server's time was valid half of it ago. Older samples are dropped
// because clocks drift. One thread at a time.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>

namespace jostle::client {

/// The clock of all times that clients pass to the library.
using Clock = std::chrono::steady_clock;

/// Microseconds of a time point since the epoch of the clock.
inline std::uint64_t to_us(Clock::time_point t) {
    return static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::microseconds>(t.time_since_epoch()).count());
}

/// 285 years. Clocks do not report later times, and sums and differences of such times stay in
/// range.
inline constexpr std::uint64_t latest_time_us = std::uint64_t{1} << 53;

/// Estimate of the offset between two clocks.
class ClockSync {
public:
    /// Adds a pong: when its ping was sent (local clock), the server's time, and the current time
    /// (local clock), all in us. Times after latest_time_us are ignored.
    void add(std::uint64_t sent_us, std::uint64_t server_us, std::uint64_t now_us);

    /// At least one sample was added.
    bool ready() const { return !samples_.empty(); }
    /// Server clock minus local clock, us; 0 until ready.
    std::int64_t offset_us() const { return offset_us_; }
    /// The server's time at a local time, us.
    std::int64_t server_us(Clock::time_point now) const {
        return static_cast<std::int64_t>(to_us(now)) + offset_us_;
    }
    double rtt_ms() const;  ///< shortest stored round trip, ms; 0 until ready

private:
    struct Sample {
        std::int64_t offset_us, rtt_us;
        std::uint64_t at_us;
    };
    std::deque<Sample> samples_;  // oldest first
    std::int64_t offset_us_ = 0;
};

}  // namespace jostle::client
