// SPDX-License-Identifier: MIT
//
// Strict JSON for untrusted input: one value with nothing before or after it, no byte order mark,
// no zero byte, bounded depth, no duplicate key in an object (parsers disagree on which duplicate
// wins, which can bypass a check).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle::server {

// Error messages describe the fault and quote nothing from the text.
Result<nlohmann::json> parse_strict_json(std::string_view text, std::size_t depth_max);

// A string member of an object; null if it is missing or not a string.
const std::string* string_member(const nlohmann::json& object, const char* name);

}  // namespace jostle::server
