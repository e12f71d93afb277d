// SPDX-License-Identifier: MIT
//
// CPU time against error of one scene: a point a row, a curve a mode.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/run_row.h"

namespace jostle::bench::accuracy {

// SVG text. `note` says where it was measured.
std::string plot_accuracy(const Experiment& experiment, const std::vector<Row>& rows,
                          const std::string& note);

}  // namespace jostle::bench::accuracy
