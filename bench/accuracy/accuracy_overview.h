// SPDX-License-Identifier: MIT
//
// Overview of all scenes in small panels: CPU time against error.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/analysis.h"

namespace jostle::bench::accuracy {

// SVG text. A panel has a line per engine through its Pareto-optimal rows, rings around the overall
// Pareto set, and on the right a mark per tolerance with the engine that reaches it with the least
// work.
std::string accuracy_overview(const std::vector<Row>& rows);

}  // namespace jostle::bench::accuracy
