// SPDX-License-Identifier: MIT
//
// All metrics as Prometheus reads them: text format 0.0.4.
#pragma once

#include <string>
#include <string_view>

namespace jostle::server {

struct Metrics;

inline constexpr std::string_view metrics_content_type = "text/plain; version=0.0.4; charset=utf-8";

// With the process as it is now. Any thread, one at a time.
std::string metrics_text(Metrics& metrics);

}  // namespace jostle::server
