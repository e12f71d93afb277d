// SPDX-License-Identifier: MIT
//
// What a load run measured, as text and JSON, and whether the plan was kept.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace jostle::load {

struct Report {
    int clients = 0, connected = 0;
    std::uint64_t inputs_sent = 0, inputs_accepted = 0, snapshots = 0;
    double kbit_per_second_per_client = 0, snapshots_per_second_per_client = 0;
    double age_ms_p50 = 0, age_ms_p99 = 0;
    std::uint64_t ages_measured = 0;  // 0: age_ms says nothing
    std::uint64_t errors = 0;
    std::optional<double>
        server_cpu_percent;  // of one core; nothing: the server is not on this machine
    std::string last_error;
};

struct Plan {
    std::optional<double> age_ms_p99_max;
    std::uint64_t errors_max = 0;
    std::optional<int> connected_min;  // default: all clients
};

// The p-th percentile (0..100); sorts the samples. 0 without samples.
double percentile(std::vector<float>& samples, double p);

std::string to_text(const Report& report);
std::string to_json(const Report& report);
// What of the plan was missed, one line each.
std::vector<std::string> missed(const Report& report, const Plan& plan);

}  // namespace jostle::load
