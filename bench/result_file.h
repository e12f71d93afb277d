// SPDX-License-Identifier: MIT
//
// The result files of the subcommands.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace jostle::bench {

// Rounds to four significant digits: the digits after them are noise, which results under version
// control should not contain.
double rounded(double value);

// Returns whether the file can be written and reports an error on stderr. Call it before a long
// measurement. Does not change an existing file.
bool can_write(const std::string& path);

// Writes the fields of the head and the rows, one row per line: results are under version control,
// where lines are compared. Reports errors on stderr.
bool write_result(const std::string& path, const nlohmann::ordered_json& head,
                  const nlohmann::ordered_json& rows);
bool write_text(const std::string& path, const std::string& text);

// Formats rows as CSV: a line of column names, in the order in which the rows first use them, and a
// line per row. Missing values and null are empty fields.
std::string csv_text(const nlohmann::ordered_json& rows);

}  // namespace jostle::bench
