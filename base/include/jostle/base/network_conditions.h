// SPDX-License-Identifier: MIT
//
// Impairments of a simulated network. Clients, the server, jostle-netem, the web SDK and the tests
// use the same parameters; network_simulator.h applies them. In flags, settings and URL parameters
// they have the names of the fields.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle {

/// Impairments of one direction of a connection. The defaults leave the connection unimpaired.
struct NetworkConditions {
    double latency_ms = 0;      ///< constant delay of every message, 0 to 60000 ms
    double jitter_ms = 0;       ///< additional delay, uniform in [0, jitter_ms), 0 to 60000 ms
    double jitter_tail_ms = 0;  ///< additional delay, exponential with this mean, 0 to 60000 ms
    double stall_ms = 0;  ///< duration of a stall, during which nothing arrives, 0 to 60000 ms
    /// Mean time from the start of one stall to the start of the next, 0 to 1e9 ms. The actual time
    /// is uniform between 0.5 and 1.5 times this value, and at least 1 ms longer than a stall.
    double stall_interval_ms = 5000;
    /// Fraction of messages that are lost, 0 to 1. Datagrams are dropped; messages of a stream are
    /// retransmitted once.
    double loss = 0;
    /// Mean number of consecutive losses, 1 to 1000. 1: losses are independent.
    double loss_burst = 1;
    double retransmit_ms = 200;  ///< additional delay of a retransmitted message, 0 to 60000 ms
    double duplicate = 0;        ///< fraction of datagrams that arrive twice, 0 to 1
    double reorder = 0;          ///< fraction of datagrams that later ones can overtake, 0 to 1
    double reorder_ms = 20;      ///< additional delay of such a datagram, 0 to 60000 ms
    double rate_kbps = 0;        ///< bandwidth, 0 to 1e7 kbit/s; 0: unlimited
    /// Maximum amount of data in transit, 0 to 1e9 bytes; 0: unlimited. Datagrams beyond it are
    /// dropped; the sender of a stream waits.
    double queue_bytes = 0;
    std::uint32_t seed = 1;  ///< seed of the random number generator

    /// Returns true if any setting delays, drops, duplicates or reorders messages.
    bool impaired() const {
        return latency_ms > 0 || jitter_ms > 0 || jitter_tail_ms > 0 || stall_ms > 0 || loss > 0 ||
               duplicate > 0 || reorder > 0 || rate_kbps > 0;
    }
};

/// Parses a comma-separated list such as "latency_ms=80,jitter_ms=20,stall_ms=250" of fields of
/// NetworkConditions. An empty text yields the defaults.
///
/// Errors: invalid_argument, naming the condition and the values that it accepts.
Result<NetworkConditions> parse_network_conditions(std::string_view text);

// ---- implementation ----

namespace network_conditions_detail {

struct Parameter {
    std::string_view name;
    double NetworkConditions::*value;
    double least, most;
};

inline constexpr Parameter parameters[] = {
    {"latency_ms", &NetworkConditions::latency_ms, 0, 60'000},
    {"jitter_ms", &NetworkConditions::jitter_ms, 0, 60'000},
    {"jitter_tail_ms", &NetworkConditions::jitter_tail_ms, 0, 60'000},
    {"stall_ms", &NetworkConditions::stall_ms, 0, 60'000},
    {"stall_interval_ms", &NetworkConditions::stall_interval_ms, 0, 1e9},
    {"loss", &NetworkConditions::loss, 0, 1},
    {"loss_burst", &NetworkConditions::loss_burst, 1, 1000},
    {"retransmit_ms", &NetworkConditions::retransmit_ms, 0, 60'000},
    {"duplicate", &NetworkConditions::duplicate, 0, 1},
    {"reorder", &NetworkConditions::reorder, 0, 1},
    {"reorder_ms", &NetworkConditions::reorder_ms, 0, 60'000},
    {"rate_kbps", &NetworkConditions::rate_kbps, 0, 1e7},
    {"queue_bytes", &NetworkConditions::queue_bytes, 0, 1e9},
};
inline constexpr std::uint32_t seed_max = 0xffffffffu;

inline Error invalid_condition(std::string_view part, const std::string& reason) {
    return {ErrorCode::invalid_argument,
            "network condition '" + std::string(part) + "': " + reason};
}

inline std::string range_text(double least, double most) {
    return "must be a number from " + std::to_string(std::llround(least)) + " to " +
           std::to_string(std::llround(most));
}

inline Status read_condition(NetworkConditions& conditions, std::string_view part) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos)
        return invalid_condition(part, "must have the form NAME=NUMBER");
    const std::string_view name = part.substr(0, equals), text = part.substr(equals + 1);
    double value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = failure == std::errc() && end == text.data() + text.size();
    if (name == "seed") {
        if (!is_number || !(value >= 0 && value <= seed_max) || value != std::floor(value))
            return invalid_condition(part, "must be a whole number from 0 to 4294967295");
        conditions.seed = static_cast<std::uint32_t>(value);
        return {};
    }
    std::string names;
    for (const Parameter& parameter : parameters) {
        if (parameter.name == name) {
            if (!is_number || !(value >= parameter.least && value <= parameter.most))
                return invalid_condition(part, range_text(parameter.least, parameter.most));
            conditions.*parameter.value = value;
            return {};
        }
        names += std::string(parameter.name) + ", ";
    }
    return invalid_condition(part, "unknown name; must be one of " + names + "seed");
}

}  // namespace network_conditions_detail

inline Result<NetworkConditions> parse_network_conditions(std::string_view text) {
    NetworkConditions conditions;
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        if (const Status read =
                network_conditions_detail::read_condition(conditions, text.substr(0, comma));
            !read.ok())
            return read.error();
        text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
    }
    return conditions;
}

}  // namespace jostle
