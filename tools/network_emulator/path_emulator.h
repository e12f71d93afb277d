// SPDX-License-Identifier: MIT
//
// One direction of an emulated network path: computes the time at which bytes are forwarded.
// Seeded, so that a run is repeatable. TCP streams lose no data; packet loss appears as a stall,
// because all later data waits for the lost segment. A value; one thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <random>

namespace jostle::network_emulator {

using Clock = std::chrono::steady_clock;

struct NetworkConditions {
    double delay_ms = 0;         // of each piece
    double jitter_ms = 0;        // additional delay, uniform in [0, jitter_ms)
    double stall_every_s = 0;    // mean time between stalls; 0: none
    double stall_ms = 200;       // duration of a stall, in which nothing arrives
    double kbit_per_second = 0;  // 0: unlimited
    double loss = 0;             // share of lost packets, 0 to 1; not for streams
    std::uint64_t seed = 1;
};

class PathEmulator {
public:
    // `stream`: paths with the same settings and different stream numbers behave differently.
    PathEmulator(const NetworkConditions& settings, std::uint64_t stream, Clock::time_point now);

    // Arrival time of bytes received now; never earlier than that of previous bytes.
    Clock::time_point arrival_time(std::size_t bytes, Clock::time_point now);

    // Whether this packet is lost.
    bool drops_packet() { return settings_.loss > 0 && random() < settings_.loss; }

private:
    double random();  // 0 to 1
    void advance_stalls(Clock::time_point until);

    NetworkConditions settings_;
    std::mt19937_64 generator_;
    Clock::time_point free_at_, last_, stall_begins_, stall_ends_;
};

}  // namespace jostle::network_emulator
