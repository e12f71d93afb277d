// SPDX-License-Identifier: MIT
//
// Process metrics from the operating system, with the conventional Prometheus names.
#pragma once

namespace jostle::server {

struct Metrics;

// Reads /proc/self into `metrics`; values that cannot be read remain unchanged.
void read_process_metrics(Metrics& metrics);

}  // namespace jostle::server
