// SPDX-License-Identifier: MIT
//
// Plot of CPU time against error of one scene: one point per row, one curve per mode.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/run_row.h"

namespace jostle::bench::accuracy {

// SVG text. `note` describes the machine.
std::string plot_accuracy(const Experiment& experiment, const std::vector<Row>& rows,
                          const std::string& note);

}  // namespace jostle::bench::accuracy
