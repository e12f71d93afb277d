// SPDX-License-Identifier: MIT
//
// Formats the results of jostle-bench accuracy as text and JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/accuracy/analysis.h"

namespace jostle::bench::accuracy {

// Report of one scene: errors at 60 Hz and orders of all engines and modes, least work per
// tolerance, Pareto set.
std::string scene_report(const Experiment& experiment, const std::vector<Row>& rows);

// The score, and the rows in which Jostle needs more work.
std::string score_report(const Score& score);

// The scenes as CSV. Columns: scene, description, error and second_error (the measures of these
// columns of the rows, with units), tolerances (separated by spaces).
std::string scenes_csv(const std::vector<const Experiment*>& experiments);

// The same values as JSON.
nlohmann::ordered_json work_json(const std::vector<Row>& rows);
nlohmann::ordered_json score_json(const Score& score);

// Generates the tables of docs/records/accuracy.md, between <!-- begin NAME --> and <!-- end NAME
// -->. --tables rewrites them, so that no values are copied by hand.

std::string jostle_table(const std::vector<Row>& rows);  // Jostle's default mode at 60 Hz
std::string family_table(const std::vector<Row>& rows);  // the worst member of each family
std::string score_table(const Score& score);  // the score, and the rows in which a peer is better
std::string stability_table(const nlohmann::ordered_json& rows);  // of the JSON of stability

// Reports errors on stderr: the file, or a missing section.
bool replace_section(const std::string& path, const std::string& name, const std::string& text);

}  // namespace jostle::bench::accuracy
