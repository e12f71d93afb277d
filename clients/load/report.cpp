// SPDX-License-Identifier: MIT
#include "load/report.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace jostle::load {

double percentile(std::vector<float>& samples, double p) {
    if (samples.empty()) return 0;
    std::sort(samples.begin(), samples.end());
    const auto last = static_cast<double>(samples.size() - 1);
    return static_cast<double>(samples[static_cast<std::size_t>(last * p / 100 + 0.5)]);
}

std::string to_text(const Report& r) {
    char text[1024];
    char cpu[32] = "not known";
    if (r.server_cpu_percent) std::snprintf(cpu, sizeof cpu, "%.1f", *r.server_cpu_percent);
    std::snprintf(text, sizeof text,
                  "clients                          %d\n"
                  "connected                        %d\n"
                  "inputs_sent                      %llu\n"
                  "inputs_accepted                  %llu\n"
                  "snapshots                        %llu\n"
                  "kbit_per_second_per_client       %.1f\n"
                  "snapshots_per_second_per_client  %.1f\n"
                  "age_ms_p50                       %.2f\n"
                  "age_ms_p99                       %.2f\n"
                  "errors                           %llu\n"
                  "server_cpu_percent               %s\n",
                  r.clients, r.connected, static_cast<unsigned long long>(r.inputs_sent),
                  static_cast<unsigned long long>(r.inputs_accepted),
                  static_cast<unsigned long long>(r.snapshots), r.kbit_per_second_per_client,
                  r.snapshots_per_second_per_client, r.age_ms_p50, r.age_ms_p99,
                  static_cast<unsigned long long>(r.errors), cpu);
    return text;
}

std::string to_json(const Report& r) {
    nlohmann::ordered_json json = {
        {"clients", r.clients},
        {"connected", r.connected},
        {"inputs_sent", r.inputs_sent},
        {"inputs_accepted", r.inputs_accepted},
        {"snapshots", r.snapshots},
        {"kbit_per_second_per_client", r.kbit_per_second_per_client},
        {"snapshots_per_second_per_client", r.snapshots_per_second_per_client},
        {"age_ms_p50", r.age_ms_p50},
        {"age_ms_p99", r.age_ms_p99},
        {"errors", r.errors}};
    if (r.server_cpu_percent)
        json["server_cpu_percent"] = *r.server_cpu_percent;
    else
        json["server_cpu_percent"] = nullptr;
    return json.dump(2) + "\n";
}

std::vector<std::string> missed(const Report& r, const Plan& plan) {
    std::vector<std::string> lines;
    const int wanted = plan.connected_min.value_or(r.clients);
    if (r.connected < wanted)
        lines.push_back(std::to_string(r.connected) +
                        " clients were connected to the end; the plan asks for " +
                        std::to_string(wanted));
    if (r.errors > plan.errors_max)
        lines.push_back(std::to_string(r.errors) + " errors; the plan allows " +
                        std::to_string(plan.errors_max) +
                        (r.last_error.empty() ? "" : " (the last one: " + r.last_error + ")"));
    if (plan.age_ms_p99_max && r.ages_measured == 0)
        lines.push_back("no age was measured; the plan asks for an age_ms_p99");
    else if (plan.age_ms_p99_max && !(r.age_ms_p99 <= *plan.age_ms_p99_max))
        lines.push_back("age_ms_p99 is " + std::to_string(r.age_ms_p99) + "; the plan allows " +
                        std::to_string(*plan.age_ms_p99_max));
    if (r.snapshots == 0) lines.push_back("no snapshot arrived");
    return lines;
}

}  // namespace jostle::load
