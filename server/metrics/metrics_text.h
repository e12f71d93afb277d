// SPDX-License-Identifier: MIT
//
// All metrics in the Prometheus text format 0.0.4.
#pragma once

#include <string>
#include <string_view>

namespace jostle::server {

struct Metrics;

inline constexpr std::string_view metrics_content_type = "text/plain; version=0.0.4; charset=utf-8";

// Includes the current process metrics. Any thread, one call at a time.
std::string metrics_text(Metrics& metrics);

// Reads /proc/self into `metrics`: process metrics with the conventional Prometheus names. Values
// that cannot be read remain unchanged.
void read_process_metrics(Metrics& metrics);

}  // namespace jostle::server
