// SPDX-License-Identifier: MIT
#include "tools/load/load_metrics.h"

#include <algorithm>
#include <utility>

namespace jostle::load {

void LoadMetrics::add_age(std::int64_t us, Clock::time_point now) {
    age.add(us);
    const auto window = static_cast<std::size_t>(std::max<std::int64_t>(
        0, std::chrono::duration_cast<std::chrono::seconds>(now - start_).count() / window_s));
    if (age_windows.size() <= window) age_windows.resize(window + 1);
    age_windows[window].add(us);
}

void LoadMetrics::add_error(const std::string& what) {
    errors++;
    last_error = what;
}

void LoadMetrics::begin(Clock::time_point now) {
    LoadMetrics fresh;
    fresh.errors = errors;
    fresh.last_error = std::move(last_error);
    fresh.start_ = now;
    *this = std::move(fresh);
}

void LoadMetrics::end(Clock::time_point now) {
    seconds = std::chrono::duration<double>(now - start_).count();
}

void LoadMetrics::merge(const LoadMetrics& other) {
    messages += other.messages;
    bytes += other.bytes;
    snapshots += other.snapshots;
    snapshot_bytes += other.snapshot_bytes;
    decoded += other.decoded;
    inputs_sent += other.inputs_sent;
    inputs_applied += other.inputs_applied;
    errors += other.errors;
    if (last_error.empty()) last_error = other.last_error;
    seconds = std::max(seconds, other.seconds);
    cpu_seconds += other.cpu_seconds;
    age.merge(other.age);
    gap.merge(other.gap);
    result_delay.merge(other.result_delay);
    effect_delay.merge(other.effect_delay);
    age_windows.resize(std::max(age_windows.size(), other.age_windows.size()));
    for (std::size_t k = 0; k < other.age_windows.size(); k++)
        age_windows[k].merge(other.age_windows[k]);
}

}  // namespace jostle::load
