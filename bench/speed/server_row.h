// SPDX-License-Identifier: MIT
//
// One line of the server table: a scene that a real server hosts for real clients, how long its
// ticks took, how many were late, and what the clients got.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace jostle::bench {

struct ServerRow {
    std::string scene, name;  // letter and name
    int threads = 1;          // of the world's step
    int clients = 0;
    double seconds = 0;                 // for how long
    std::optional<std::string> failed;  // why there are no figures

    int bodies = 0;
    double hz = 0;
    int ticks = 0;              // that ran
    int late_ticks = 0;         // that never ran: the world was late by more than it may catch up
    double late_share = 0;      // of all that were due
    int ticks_over_period = 0;  // that took longer than there is time between two
    double ms_mean = 0, ms_p99 = 0, ms_worst = 0;  // of a tick: inputs, step, frame, answers
    double begun_late_ms_worst = 0;                // from when a tick was due to when it began
    // "holds": each tick took less than a period. "catches up": some took longer, none was given
    // up. "late": some were.
    std::string verdict;

    // As jostle-load reports them: decoded snapshots, and their age when they were.
    int connected = 0;  // to the end
    double snapshots_per_second_per_client = 0, kbit_per_second_per_client = 0;
    double age_ms_p50 = 0, age_ms_p99 = 0;
    int errors = 0;
    std::optional<double> server_cpu_percent;  // of one core
};

// From ticks, late_ticks and ticks_over_period.
const char* verdict_of(const ServerRow& row);

nlohmann::ordered_json to_json(const ServerRow& row);

}  // namespace jostle::bench
