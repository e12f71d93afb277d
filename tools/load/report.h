// SPDX-License-Identifier: MIT
//
// The measurements of a load run as text and JSON, and the check of its thresholds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/load/load_metrics.h"

namespace jostle::load {

struct Report {
    int clients = 0, connected = 0;
    double seconds = 0;  // duration of the measurement
    std::uint64_t inputs_sent = 0, inputs_accepted = 0, snapshots = 0;
    double kbit_per_second_per_client = 0, snapshots_per_second_per_client = 0;
    double messages_per_second_per_client = 0;
    std::uint64_t user_messages = 0, messages_missed = 0;
    double snapshot_bytes = 0;  // mean; 0: not measured
    double decoded_share = 0;   // share of the snapshots whose CRC was verified
    double frozen_share = 0;    // of the rendered frames; 0: none was rendered
    Percentiles age_ms, gap_ms, result_delay_ms, effect_delay_ms, message_delay_ms;
    std::vector<Percentiles> age_windows_ms;  // in intervals of 10 s
    std::uint64_t errors = 0;
    std::optional<double>
        server_cpu_percent;  // of one core; nothing: the server is on another machine
    double load_cpu_us = 0;  // of jostle-load per received message; 0: not measured
    std::string last_error;
};

struct LoadThresholds {
    std::optional<double> age_ms_p99_max;
    std::uint64_t errors_max = 0;
    std::optional<int> connected_min;  // default: all clients
};

// Computes the report of `clients` clients. Fields that the metrics do not contain keep their
// defaults.
Report make_report(const LoadMetrics& metrics, int clients);

std::string to_text(const Report& report);
std::string to_json(const Report& report);
// Describes the violated thresholds, one line each.
std::vector<std::string> violated_thresholds(const Report& report, const LoadThresholds& plan);

}  // namespace jostle::load
