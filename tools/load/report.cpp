// SPDX-License-Identifier: MIT
#include "tools/load/report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "jostle/base/format_text.h"

namespace jostle::load {
namespace {

std::string line(const char* name, double value, int digits) {
    return format_text("%-31s  %.*f\n", name, digits, value);
}

std::string percentiles_line(const char* name, const Percentiles& p) {
    if (p.count == 0) return format_text("%-31s  not measured\n", name);
    return format_text("%-31s  p50 %.2f  p90 %.2f  p99 %.2f  p99.9 %.2f  max %.2f\n", name, p.p50,
                       p.p90, p.p99, p.p99_9, p.max);
}

nlohmann::ordered_json percentiles_json(const Percentiles& p) {
    if (p.count == 0) return nullptr;
    return {{"count", p.count}, {"p50", p.p50},     {"p90", p.p90},
            {"p99", p.p99},     {"p99_9", p.p99_9}, {"max", p.max}};
}

}  // namespace

Report make_report(const LoadMetrics& f, int clients) {
    const double client_seconds = std::max(1e-3, f.seconds) * std::max(1, clients);
    const auto rate = [&](std::uint64_t count) {
        return static_cast<double>(count) / client_seconds;
    };
    Report report{.clients = clients,
                  .seconds = f.seconds,
                  .inputs_sent = f.inputs_sent,
                  .inputs_accepted = f.inputs_applied,
                  .snapshots = f.snapshots,
                  .kbit_per_second_per_client = rate(f.bytes) * 8 / 1000,
                  .snapshots_per_second_per_client = rate(f.snapshots),
                  .messages_per_second_per_client = rate(f.messages),
                  .user_messages = f.user_messages,
                  .messages_missed = f.messages_missed,
                  .age_ms = percentiles_of(f.age),
                  .gap_ms = percentiles_of(f.gap),
                  .result_delay_ms = percentiles_of(f.result_delay),
                  .effect_delay_ms = percentiles_of(f.effect_delay),
                  .message_delay_ms = percentiles_of(f.message_delay),
                  .age_windows_ms = {},
                  .errors = f.errors,
                  .server_cpu_percent = {},
                  .last_error = f.last_error};
    if (f.snapshots > 0) {
        const auto snapshots = static_cast<double>(f.snapshots);
        report.snapshot_bytes = static_cast<double>(f.snapshot_bytes) / snapshots;
        report.decoded_share = static_cast<double>(f.decoded) / snapshots;
    }
    if (f.rendered > 0)
        report.frozen_share = static_cast<double>(f.frozen) / static_cast<double>(f.rendered);
    if (f.messages > 0) report.load_cpu_us = 1e6 * f.cpu_seconds / static_cast<double>(f.messages);
    for (const Histogram& window : f.age_windows)
        report.age_windows_ms.push_back(percentiles_of(window));
    return report;
}

std::string to_text(const Report& r) {
    std::string text =
        line("clients", r.clients, 0) + line("connected", r.connected, 0) +
        line("seconds", r.seconds, 1) + line("inputs_sent", static_cast<double>(r.inputs_sent), 0) +
        line("inputs_accepted", static_cast<double>(r.inputs_accepted), 0) +
        line("snapshots", static_cast<double>(r.snapshots), 0) +
        line("kbit_per_second_per_client", r.kbit_per_second_per_client, 1) +
        line("snapshots_per_second_per_client", r.snapshots_per_second_per_client, 1);
    if (r.messages_per_second_per_client > 0)
        text += line("messages_per_second_per_client", r.messages_per_second_per_client, 1);
    if (r.snapshot_bytes > 0) text += line("snapshot_bytes", r.snapshot_bytes, 0);
    text += line("decoded_share", r.decoded_share, 3) + line("frozen_share", r.frozen_share, 4) +
            percentiles_line("age_ms", r.age_ms) + percentiles_line("gap_ms", r.gap_ms) +
            percentiles_line("result_delay_ms", r.result_delay_ms) +
            percentiles_line("effect_delay_ms", r.effect_delay_ms);
    if (r.user_messages > 0)
        text += line("user_messages", static_cast<double>(r.user_messages), 0) +
                line("messages_missed", static_cast<double>(r.messages_missed), 0) +
                percentiles_line("message_delay_ms", r.message_delay_ms);
    if (r.age_windows_ms.size() > 1)
        for (std::size_t k = 0; k < r.age_windows_ms.size(); k++)
            text += percentiles_line(
                format_text("  age_ms from %zu s", k * LoadMetrics::window_s).c_str(),
                r.age_windows_ms[k]);
    text += line("errors", static_cast<double>(r.errors), 0);
    if (r.load_cpu_us > 0) text += line("load_cpu_us_per_message", r.load_cpu_us, 1);
    return text + (r.server_cpu_percent ? line("server_cpu_percent", *r.server_cpu_percent, 1)
                                        : format_text("%-31s  unknown\n", "server_cpu_percent"));
}

std::string to_json(const Report& r) {
    nlohmann::ordered_json windows = nlohmann::ordered_json::array();
    for (const Percentiles& window : r.age_windows_ms) windows.push_back(percentiles_json(window));
    nlohmann::ordered_json json = {
        {"clients", r.clients},
        {"connected", r.connected},
        {"seconds", r.seconds},
        {"inputs_sent", r.inputs_sent},
        {"inputs_accepted", r.inputs_accepted},
        {"snapshots", r.snapshots},
        {"kbit_per_second_per_client", r.kbit_per_second_per_client},
        {"snapshots_per_second_per_client", r.snapshots_per_second_per_client},
        {"messages_per_second_per_client", r.messages_per_second_per_client},
        {"snapshot_bytes", r.snapshot_bytes},
        {"decoded_share", r.decoded_share},
        {"frozen_share", r.frozen_share},
        {"age_ms_p50", r.age_ms.p50},
        {"age_ms_p99", r.age_ms.p99},
        {"age_ms", percentiles_json(r.age_ms)},
        {"gap_ms", percentiles_json(r.gap_ms)},
        {"result_delay_ms", percentiles_json(r.result_delay_ms)},
        {"effect_delay_ms", percentiles_json(r.effect_delay_ms)},
        {"user_messages", r.user_messages},
        {"messages_missed", r.messages_missed},
        {"message_delay_ms", percentiles_json(r.message_delay_ms)},
        {"age_window_seconds", LoadMetrics::window_s},
        {"age_windows_ms", windows},
        {"errors", r.errors},
        {"load_cpu_us_per_message", r.load_cpu_us}};
    if (r.server_cpu_percent)
        json["server_cpu_percent"] = *r.server_cpu_percent;
    else
        json["server_cpu_percent"] = nullptr;
    return json.dump(2) + "\n";
}

std::vector<std::string> violated_thresholds(const Report& r, const LoadThresholds& plan) {
    std::vector<std::string> lines;
    const int required = plan.connected_min.value_or(r.clients);
    if (r.connected < required)
        lines.push_back(std::to_string(r.connected) +
                        " clients were connected at the end; --min-connected requires " +
                        std::to_string(required));
    if (r.errors > plan.errors_max)
        lines.push_back(std::to_string(r.errors) + " errors; --max-errors allows " +
                        std::to_string(plan.errors_max) +
                        (r.last_error.empty() ? "" : " (last error: " + r.last_error + ")"));
    if (plan.age_ms_p99_max && r.age_ms.count == 0)
        lines.push_back("no age was measured, but --max-age-p99-ms is set");
    else if (plan.age_ms_p99_max && !(r.age_ms.p99 <= *plan.age_ms_p99_max))
        lines.push_back("age_ms_p99 is " + std::to_string(r.age_ms.p99) +
                        "; --max-age-p99-ms allows " + std::to_string(*plan.age_ms_p99_max));
    if (r.snapshots == 0) lines.push_back("no snapshots received");
    return lines;
}

}  // namespace jostle::load
