// SPDX-License-Identifier: MIT
//
// What jostle-bench accuracy says of its rows, as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/accuracy/analysis.h"

namespace jostle::bench::accuracy {

// Of one scene: the errors at 60 Hz and orders of every engine and mode, the least work for each
// tolerance, the Pareto set.
std::string scene_report(const Experiment& experiment, const std::vector<Row>& rows);

// The score, and the rows in which Jostle is behind.
std::string score_report(const Score& score);

// The same figures for machines.
nlohmann::ordered_json work_json(const std::vector<Row>& rows);
nlohmann::ordered_json score_json(const Score& score);

}  // namespace jostle::bench::accuracy
