// SPDX-License-Identifier: MIT
//
// Network simulator for tests and demonstrations. It computes the time at which a message sent now
// arrives at the other end. Messages of a stream are never lost or reordered, as on TCP: a lost
// message arrives after one retransmission delay and delays the messages behind it. Datagrams can
// be lost, duplicated and reordered. The same seed produces the same arrival times in C++ and in
// TypeScript (network_simulator.ts of the web SDK; tests/base/network_simulator_vectors.json).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "jostle/base/network_conditions.h"

namespace jostle {

enum class Delivery { stream, datagrams };

/// Result of sending one message.
struct Transit {
    int copies = 1;               ///< 0: lost, 2: duplicated. 1 on a stream
    std::int64_t arrival_us = 0;  ///< of all copies
};

/// Computes the arrival times of the messages of one direction of a connection. Not thread-safe:
/// one thread at a time.
class NetworkSimulator {
public:
    /// Starts with a fresh random sequence. Simulators with different `path` numbers have different
    /// sequences. Precondition: the conditions are within their ranges.
    explicit NetworkSimulator(const NetworkConditions& conditions, std::uint32_t path = 0,
                              Delivery delivery = Delivery::stream);

    /// Sends a message of `bytes` at `sent_us`, in microseconds of one arbitrary clock, which must
    /// not decrease. Arrival times never decrease either, except those of reordered datagrams.
    Transit send(std::int64_t sent_us, std::size_t bytes = 0);

private:
    double next_uniform();  // in [0, 1)
    bool next_lost();
    double next_transit_ms();
    std::int64_t departure_us(std::int64_t sent_us, std::size_t bytes);
    std::int64_t after_stalls(std::int64_t arrival_us);

    NetworkConditions conditions_;
    Delivery delivery_;
    std::uint32_t random_;
    std::int64_t last_arrival_us_ = 0;
    std::int64_t stall_us_ = 0;  // start of the current or the next stall
    double free_us_ = 0;         // when the previous message has been transmitted
    bool started_ = false, previous_lost_ = false;
};

// ---- implementation ----

namespace network_simulator_detail {

inline std::int64_t to_us(double ms) {
    return std::llround(1000 * ms);
}

}  // namespace network_simulator_detail

inline NetworkSimulator::NetworkSimulator(const NetworkConditions& conditions, std::uint32_t path,
                                          Delivery delivery)
    : conditions_(conditions),
      delivery_(delivery),
      random_(conditions.seed ^ (0x9e3779b9u * path)) {}

// Mulberry32 (Tommy Ettinger). It uses 32-bit operations only, so JavaScript produces the same
// numbers.
inline double NetworkSimulator::next_uniform() {
    random_ += 0x6d2b79f5u;
    std::uint32_t t = (random_ ^ (random_ >> 15)) * (random_ | 1u);
    t ^= t + (t ^ (t >> 7)) * (t | 61u);
    return (t ^ (t >> 14)) / 4294967296.0;
}

// Bursts are a two-state Markov chain (E. N. Gilbert, 1960): it enters a burst so that the total
// fraction is `loss`, and leaves it after `loss_burst` messages on average.
inline bool NetworkSimulator::next_lost() {
    const double loss = conditions_.loss, burst = conditions_.loss_burst;
    if (!(loss > 0)) return false;
    double probability = loss;
    if (burst > 1 && loss < 1)
        probability = previous_lost_ ? 1 - 1 / burst : loss / (burst * (1 - loss));
    return previous_lost_ = next_uniform() < probability;
}

inline double NetworkSimulator::next_transit_ms() {
    double transit_ms = conditions_.latency_ms;
    if (conditions_.jitter_ms > 0) transit_ms += conditions_.jitter_ms * next_uniform();
    if (conditions_.jitter_tail_ms > 0)
        transit_ms -= conditions_.jitter_tail_ms * std::log(1 - next_uniform());
    return transit_ms;
}

inline std::int64_t NetworkSimulator::departure_us(std::int64_t sent_us, std::size_t bytes) {
    if (!(conditions_.rate_kbps > 0)) return sent_us;
    free_us_ = std::max(free_us_, static_cast<double>(sent_us)) +
               8000 * static_cast<double>(bytes) / conditions_.rate_kbps;
    return std::llround(free_us_);
}

inline std::int64_t NetworkSimulator::after_stalls(std::int64_t arrival_us) {
    if (!(conditions_.stall_ms > 0)) return arrival_us;
    const std::int64_t length = network_simulator_detail::to_us(conditions_.stall_ms);
    while (arrival_us >= stall_us_ + length) {
        // A stall starts only after the previous one has ended.
        const double gap_ms = conditions_.stall_interval_ms * (0.5 + next_uniform());
        stall_us_ += std::max(network_simulator_detail::to_us(gap_ms), length + 1000);
    }
    return arrival_us >= stall_us_ ? stall_us_ + length : arrival_us;
}

inline Transit NetworkSimulator::send(std::int64_t sent_us, std::size_t bytes) {
    if (!started_) {
        started_ = true;
        stall_us_ = sent_us + network_simulator_detail::to_us(conditions_.stall_interval_ms *
                                                              (0.5 + next_uniform()));
    }
    const std::int64_t departs_us = departure_us(sent_us, bytes);
    double transit_ms = next_transit_ms();
    const bool lost = next_lost();
    if (lost && delivery_ == Delivery::datagrams) return {.copies = 0};
    if (lost) transit_ms += conditions_.retransmit_ms;
    const std::int64_t arrival_us =
        std::max(departs_us + network_simulator_detail::to_us(transit_ms), last_arrival_us_);
    Transit transit{.arrival_us = last_arrival_us_ = after_stalls(arrival_us)};
    if (delivery_ == Delivery::datagrams) {
        if (conditions_.duplicate > 0 && next_uniform() < conditions_.duplicate) transit.copies = 2;
        if (conditions_.reorder > 0 && next_uniform() < conditions_.reorder)
            transit.arrival_us += network_simulator_detail::to_us(conditions_.reorder_ms);
    }
    return transit;
}

}  // namespace jostle
