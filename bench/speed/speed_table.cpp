// SPDX-License-Identifier: MIT
#include "bench/speed/speed_table.h"

#include <cstdio>

namespace jostle::bench {
namespace {

template <class... Values>
std::string print(const char* format, Values... values) {
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

constexpr const char* nothing = "-";

std::string millimetres(const std::optional<double>& metres) {
    return metres ? print("%.3g", 1e3 * *metres) : nothing;
}

std::string milliseconds(const std::optional<double>& value) {
    return value ? print("%.4g", *value) : nothing;
}

std::string count(const std::optional<int>& value) {
    return value ? std::to_string(*value) : nothing;
}

// Right-aligned in a column; longer text is not truncated and shifts the rest of the line.
std::string cell(const std::string& text, int width) {
    return print(" %*s", width, text.c_str());
}

// Parameters of the scene and warnings, after the last column.
std::string remarks(const SpeedRow& row) {
    std::string text = parameter_text(row.parameters);
    if (!text.empty()) text = "  " + text;
    if (row.bodies_lost.value_or(0) > 0)
        text += "  " + std::to_string(*row.bodies_lost) + " bodies lost";
    if (!row.repeats.value_or(true)) text += "  the second run differs";
    return text;
}

std::string identity(const std::string& first, const std::string& engine, int threads) {
    return print("%-30s %-7s %3d", first.c_str(), engine.c_str(), threads);
}

// Followed by the rate.
const char* verdict_text(const std::string& verdict) {
    if (verdict == "holds") return "holds ";
    return verdict == "late" ? "does not hold " : "catches up with ";
}

}  // namespace

std::string speed_heading() {
    return print("%-30s %-7s %3s %6s %5s %9s %9s %9s %9s %9s %9s %5s", "scene", "engine", "thr",
                 "bodies", "steps", "ms_mean", "moving", "rest", "ms_p99", "ms_worst", "ms_first",
                 "clock") +
           print(" %8s %8s %8s %6s %8s %8s", "deep_mm", "peak_mm", "mean_mm", ">1cm", "drift_mm",
                 "worst_mm") +
           print(" %6s %6s %6s %8s %6s %6s", "asleep", "awake", "moving", "top_m", "tunnel", "MiB");
}

std::string speed_line(const SpeedRow& row) {
    const std::string start = identity(row.scene + " " + row.name, row.engine, row.threads);
    if (row.failed) return start + remarks(row) + "  failed: " + *row.failed;
    return start + print(" %6d %5d %9.4g", row.bodies, row.steps, row.ms_mean) +
           cell(milliseconds(row.ms_moving_mean), 9) + cell(milliseconds(row.ms_rest_mean), 9) +
           print(" %9.4g %9.4g %9.4g %5s", row.ms_p99, row.ms_worst, row.ms_first,
                 row.clock.c_str()) +
           cell(millimetres(row.max_penetration_m), 8) +
           cell(millimetres(row.peak_penetration_m), 8) +
           cell(millimetres(row.mean_penetration_m), 8) + cell(count(row.contacts_over_1cm), 6) +
           cell(millimetres(row.joint_drift_m), 8) + cell(millimetres(row.peak_joint_drift_m), 8) +
           cell(count(row.asleep_at_step), 6) + cell(count(row.awake_at_end), 6) +
           cell(count(row.moving_at_end), 6) + print(" %8.3f", row.top_m) +
           cell(count(row.tunnelled), 6) + print(" %6.1f", row.rss_mib) + remarks(row);
}

std::string growth_heading() {
    return print("%-30s %-7s %3s %8s %5s %10s", "scene and bodies", "engine", "thr", "ms_mean",
                 "clock", "bytes/body");
}

std::string growth_line(const GrowthRow& row) {
    const std::string start =
        identity(row.scene + " of " + std::to_string(row.bodies), row.engine, row.threads);
    if (row.failed) return start + "  failed: " + *row.failed;
    return start + print(" %8.4g %5s %10.0f", row.ms_mean, row.clock.c_str(), row.bytes_per_body);
}

std::string growth_fit_line(const GrowthFit& fit) {
    const std::string start = identity("exponent of bodies", fit.engine, fit.threads);
    return start + cell(fit.exponent ? print("%.3f", *fit.exponent) : nothing, 8);
}

std::string server_heading() {
    return print("%-30s %3s %6s %6s %5s %6s %6s %9s %9s %9s %9s", "scene", "thr", "bodies", "ticks",
                 "late", "late%", "over", "ms_mean", "ms_p99", "ms_worst", "begun") +
           print(" %9s %7s %8s %8s %8s %6s %5s  %s", "clients", "snaps/s", "kbit/s", "age_p50",
                 "age_p99", "errors", "cpu%", "at its rate");
}

std::string server_line(const ServerRow& row) {
    const std::string start = print("%-30s %3d", (row.scene + " " + row.name).c_str(), row.threads);
    if (row.failed) return start + "  failed: " + *row.failed;
    const std::string connected = std::to_string(row.connected) + "/" + std::to_string(row.clients);
    return start +
           print(" %6d %6d %5d %6.3g %6d %9.4g %9.4g %9.4g %9.4g", row.bodies, row.ticks,
                 row.late_ticks, 100 * row.late_share, row.ticks_over_period, row.ms_mean,
                 row.ms_p99, row.ms_worst, row.begun_late_ms_worst) +
           print(" %9s %7.3g %8.4g %8.3g %8.3g %6d", connected.c_str(),
                 row.snapshots_per_second_per_client, row.kbit_per_second_per_client,
                 row.age_ms_p50, row.age_ms_p99, row.errors) +
           cell(row.server_cpu_percent ? print("%.0f", *row.server_cpu_percent) : nothing, 5) +
           print("  %s%.4g Hz", verdict_text(row.verdict), row.hz);
}

}  // namespace jostle::bench
