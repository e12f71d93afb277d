// SPDX-License-Identifier: MIT
//
// What a load run measured, as text and JSON, and whether the plan was kept.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/load/load_metrics.h"

namespace jostle::load {

struct Report {
    int clients = 0, connected = 0;
    double seconds = 0;  // that were measured
    std::uint64_t inputs_sent = 0, inputs_accepted = 0, snapshots = 0;
    double kbit_per_second_per_client = 0, snapshots_per_second_per_client = 0;
    double messages_per_second_per_client = 0;
    double snapshot_bytes = 0;  // mean; 0: not measured
    double decoded_share = 0;   // of the snapshots: those whose CRC was compared
    Percentiles age_ms, gap_ms, result_delay_ms, effect_delay_ms;
    std::vector<Percentiles> age_windows_ms;  // of 10 s each
    std::uint64_t errors = 0;
    std::optional<double>
        server_cpu_percent;  // of one core; nothing: the server is not on this machine
    double load_cpu_us = 0;  // of jostle-load, for each message that it got; 0: not measured
    std::string last_error;
};

struct LoadThresholds {
    std::optional<double> age_ms_p99_max;
    std::uint64_t errors_max = 0;
    std::optional<int> connected_min;  // default: all clients
};

// Of so many clients; what the figures do not know stays as it is.
Report make_report(const LoadMetrics& metrics, int clients);

std::string to_text(const Report& report);
std::string to_json(const Report& report);
// What of the plan was missed, one line each.
std::vector<std::string> violated_thresholds(const Report& report, const LoadThresholds& plan);

}  // namespace jostle::load
