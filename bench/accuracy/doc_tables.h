// SPDX-License-Identifier: MIT
//
// The tables of docs/records/accuracy.md. They stand between <!-- begin NAME --> and <!-- end NAME -->, and
// --tables writes them anew: nobody copies figures by hand.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/accuracy/analysis.h"

namespace jostle::bench::accuracy {

std::string jostle_table(const std::vector<Row>& rows);  // Jostle's default mode at 60 Hz
std::string score_table(const Score& score);             // the score, and where a peer is better
std::string stability_table(const nlohmann::ordered_json& rows);  // of stability's JSON

// Says on stderr what is wrong: the file, or a section that it has not.
bool replace_section(const std::string& path, const std::string& name, const std::string& text);

}  // namespace jostle::bench::accuracy
