// SPDX-License-Identifier: MIT
//
// The server's clock, from round trips of pings. The shortest round trip of the last half minute
// says most: the server's word was true half of it ago. Older ones are forgotten, because clocks
// drift. One thread at a time.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>

namespace jostle::client {

using Clock = std::chrono::steady_clock;

inline std::uint64_t to_us(Clock::time_point t) {
    return static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::microseconds>(t.time_since_epoch()).count());
}

// 285 years: no monotonic clock says more, and sums and differences of such times stay in range.
inline constexpr std::uint64_t latest_time_us = std::uint64_t{1} << 53;

class ClockSync {
public:
    // A pong came: when its ping was sent (our clock), what the server's clock said, and now (our
    // clock). Microseconds; a time that no clock says is not believed.
    void add(std::uint64_t sent_us, std::uint64_t server_us, std::uint64_t now_us);

    bool ready() const { return !samples_.empty(); }
    // Server clock minus ours; 0 until ready.
    std::int64_t offset_us() const { return offset_us_; }
    std::int64_t server_us(Clock::time_point now) const {
        return static_cast<std::int64_t>(to_us(now)) + offset_us_;
    }
    double rtt_ms() const;  // the shortest round trip that is remembered; 0 until ready

private:
    struct Sample {
        std::int64_t offset_us, rtt_us;
        std::uint64_t at_us;
    };
    std::deque<Sample> samples_;  // oldest first
    std::int64_t offset_us_ = 0;
};

}  // namespace jostle::client
