// SPDX-License-Identifier: MIT
//
// JSON from strangers: one value with nothing after it, bounded in depth, no key twice in an object
// (readers differ on which of the two counts, and that is a way past a check).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle::server {

// Errors say what is wrong and quote nothing of the text.
Result<nlohmann::json> parse_strict_json(std::string_view text, std::size_t depth_max);

// A member of an object that is a string; null: it is missing or something else.
const std::string* string_member(const nlohmann::json& object, const char* name);

}  // namespace jostle::server
