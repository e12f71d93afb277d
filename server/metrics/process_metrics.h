// SPDX-License-Identifier: MIT
//
// What the operating system says of this process, under the names that all programs give it.
#pragma once

namespace jostle::server {

struct Metrics;

// Reads /proc/self into `metrics`; what cannot be read stays as it was.
void read_process_metrics(Metrics& metrics);

}  // namespace jostle::server
