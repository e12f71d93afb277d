// SPDX-License-Identifier: MIT
//
// Network emulator for tests and demonstrations. It computes the time at which a message sent now
// arrives at the other end of a stream. Messages are never lost or reordered, as on TCP: a lost
// message arrives after one retransmission delay and delays the messages behind it. The same seed
// produces the same arrival times in C++ and in TypeScript (network_simulator.ts of the web SDK).
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle {

/// Impairments of one direction of a connection. The defaults leave the connection unimpaired.
struct NetworkConditions {
    double delay_ms = 0;   ///< constant delay of every message, 0 to 60000 ms
    double jitter_ms = 0;  ///< additional delay, uniform in [0, jitter_ms), 0 to 60000 ms
    double tail_ms = 0;    ///< additional delay, exponential with this mean, 0 to 60000 ms
    double stalls_ms = 0;  ///< duration of a stall, during which nothing arrives, 0 to 60000 ms
    /// Mean time from the start of one stall to the start of the next, 0 to 1e9 ms. The actual time
    /// is uniform between 0.5 and 1.5 times this value, and at least 1 ms longer than a stall.
    double stall_every_ms = 5000;
    double loss = 0;             ///< fraction of messages that are retransmitted once, 0 to 1
    double retransmit_ms = 200;  ///< additional delay of a retransmitted message, 0 to 60000 ms
    std::uint32_t seed = 1;      ///< seed of the random number generator

    /// Returns true if any setting delays messages.
    bool impaired() const {
        return delay_ms > 0 || jitter_ms > 0 || tail_ms > 0 || stalls_ms > 0 || loss > 0;
    }
};

/// Parses a comma-separated list such as "delay=80,jitter=20,stalls=250". The names are delay,
/// jitter, tail, stalls, stall_every, loss, retransmit and seed: the fields of NetworkConditions
/// without their units. An empty text yields the defaults.
///
/// Errors: invalid_argument, naming the setting and the values it accepts.
Result<NetworkConditions> parse_network_conditions(std::string_view text);

/// Computes the arrival times of the messages of one direction of a connection. Not thread-safe:
/// one thread at a time.
class NetworkSimulator {
public:
    /// Starts with a fresh random sequence. Precondition: the settings are within their ranges.
    explicit NetworkSimulator(const NetworkConditions& settings);

    /// Returns the arrival time of a message sent at `sent_us`. Both are in microseconds of one
    /// arbitrary clock. Arrival times never decrease: a message does not overtake earlier messages.
    std::int64_t arrival_us(std::int64_t sent_us);

private:
    double next_uniform();  // in [0, 1)
    std::int64_t after_stalls(std::int64_t arrival_us);

    NetworkConditions settings_;
    std::uint32_t random_;
    std::int64_t last_arrival_us_ = 0;
    std::int64_t stall_us_ = 0;  // start of the current or the next stall
    bool begun_ = false;
};

// ---- implementation ----

namespace network_simulator_detail {

inline constexpr double longest_ms = 60'000;

inline std::int64_t us_of(double ms) {
    return std::llround(1000 * ms);
}

inline Error invalid_setting(std::string_view part, const std::string& why) {
    return {ErrorCode::invalid_argument, "link setting '" + std::string(part) + "': " + why};
}

inline Status read_number(NetworkConditions& settings, std::string_view part) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos)
        return invalid_setting(part, "must have the form name=number");
    const std::string_view name = part.substr(0, equals), text = part.substr(equals + 1);
    double value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size() || !(value >= 0))
        return invalid_setting(part, "the value must be a number of at least 0");
    if (name == "seed") {
        if (value > 0xffffffffu)
            return invalid_setting(part, "the value must be at most 4294967295");
        settings.seed = static_cast<std::uint32_t>(value);
        return {};
    }
    struct Field {
        std::string_view name;
        double NetworkConditions::*at;
        double most;
    };
    static constexpr Field fields[] = {
        {"delay", &NetworkConditions::delay_ms, longest_ms},
        {"jitter", &NetworkConditions::jitter_ms, longest_ms},
        {"tail", &NetworkConditions::tail_ms, longest_ms},
        {"stalls", &NetworkConditions::stalls_ms, longest_ms},
        {"stall_every", &NetworkConditions::stall_every_ms, 1e9},
        {"loss", &NetworkConditions::loss, 1},
        {"retransmit", &NetworkConditions::retransmit_ms, longest_ms},
    };
    for (const Field& field : fields) {
        if (field.name != name) continue;
        if (value > field.most)
            return invalid_setting(
                part, "the value must be at most " + std::to_string(std::llround(field.most)));
        settings.*field.at = value;
        return {};
    }
    return invalid_setting(part,
                           "unknown name; must be one of delay, jitter, tail, stalls, stall_every, "
                           "loss, retransmit, seed");
}

}  // namespace network_simulator_detail

inline Result<NetworkConditions> parse_network_conditions(std::string_view text) {
    NetworkConditions settings;
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        if (const Status read =
                network_simulator_detail::read_number(settings, text.substr(0, comma));
            !read.ok())
            return read.error();
        text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
    }
    return settings;
}

inline NetworkSimulator::NetworkSimulator(const NetworkConditions& settings)
    : settings_(settings), random_(settings.seed) {}

// Mulberry32 (Tommy Ettinger). It uses 32-bit operations only, so JavaScript produces the same
// numbers.
inline double NetworkSimulator::next_uniform() {
    random_ += 0x6d2b79f5u;
    std::uint32_t t = (random_ ^ (random_ >> 15)) * (random_ | 1u);
    t ^= t + (t ^ (t >> 7)) * (t | 61u);
    return (t ^ (t >> 14)) / 4294967296.0;
}

inline std::int64_t NetworkSimulator::after_stalls(std::int64_t arrival_us) {
    const std::int64_t length = network_simulator_detail::us_of(settings_.stalls_ms);
    while (arrival_us >= stall_us_ + length) {
        // A stall starts only after the previous one has ended.
        const double gap_ms = settings_.stall_every_ms * (0.5 + next_uniform());
        stall_us_ += std::max(network_simulator_detail::us_of(gap_ms), length + 1000);
    }
    return arrival_us >= stall_us_ ? stall_us_ + length : arrival_us;
}

inline std::int64_t NetworkSimulator::arrival_us(std::int64_t sent_us) {
    if (!begun_) {
        begun_ = true;
        stall_us_ = sent_us + network_simulator_detail::us_of(settings_.stall_every_ms *
                                                              (0.5 + next_uniform()));
    }
    double transit_ms = settings_.delay_ms;
    if (settings_.jitter_ms > 0) transit_ms += settings_.jitter_ms * next_uniform();
    if (settings_.tail_ms > 0) transit_ms -= settings_.tail_ms * std::log(1 - next_uniform());
    if (settings_.loss > 0 && next_uniform() < settings_.loss)
        transit_ms += settings_.retransmit_ms;
    std::int64_t arrival =
        std::max(sent_us + network_simulator_detail::us_of(transit_ms), last_arrival_us_);
    if (settings_.stalls_ms > 0) arrival = after_stalls(arrival);
    return last_arrival_us_ = arrival;
}

}  // namespace jostle
