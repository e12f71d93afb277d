// SPDX-License-Identifier: MIT
//
// The files in which subcommands leave their figures.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace jostle::bench {

// Four digits: what comes after is noise, and a result under version control should show no more.
double rounded(double value);

// Whether a file can be written there; says on stderr what is wrong. Ask before measuring for an
// hour. Leaves an existing file as it is.
bool can_write(const std::string& path);

// The head's fields and the rows, a row a line: results are under version control, where lines are
// compared. Says on stderr what went wrong.
bool write_result(const std::string& path, const nlohmann::ordered_json& head,
                  const nlohmann::ordered_json& rows);
bool write_text(const std::string& path, const std::string& text);

}  // namespace jostle::bench
