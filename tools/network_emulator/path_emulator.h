// SPDX-License-Identifier: MIT
//
// One direction of a bad link: when bytes that came now may go on. Seeded, so that a run can be
// repeated. TCP loses nothing, so what loss does to it is a stall: all that comes after the lost
// segment waits for it. A value; one thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <random>

namespace jostle::network_emulator {

using Clock = std::chrono::steady_clock;

struct NetworkConditions {
    double delay_ms = 0;         // of each piece ...
    double jitter_ms = 0;        // ... and up to so much more, uniformly
    double stall_every_s = 0;    // mean time between stalls; 0: none
    double stall_ms = 200;       // nothing arrives for so long
    double kbit_per_second = 0;  // 0: any number
    double loss = 0;             // share of packets, 0 to 1: of whole packets, never of streams
    std::uint64_t seed = 1;
};

class PathEmulator {
public:
    // `stream`: links of the same settings and different numbers differ.
    PathEmulator(const NetworkConditions& settings, std::uint64_t stream, Clock::time_point now);

    // When bytes that came now arrive; never before those that came earlier.
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
