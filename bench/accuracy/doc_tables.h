// SPDX-License-Identifier: MIT
//
// Generates the tables of docs/records/accuracy.md, between <!-- begin NAME --> and <!-- end NAME
// -->. --tables rewrites them, so that no values are copied by hand.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/accuracy/analysis.h"

namespace jostle::bench::accuracy {

std::string jostle_table(const std::vector<Row>& rows);  // Jostle's default mode at 60 Hz
std::string score_table(const Score& score);  // the score, and the rows in which a peer is better
std::string stability_table(const nlohmann::ordered_json& rows);  // of the JSON of stability

// Reports errors on stderr: the file, or a missing section.
bool replace_section(const std::string& path, const std::string& name, const std::string& text);

}  // namespace jostle::bench::accuracy
