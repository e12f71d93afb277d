// SPDX-License-Identifier: MIT
//
// Location of a value in a JSON text as a path from the root. Keys are untrusted and may contain
// any character, so they are stored separately and only joined for display.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace jostle::scenes {

struct JsonPathStep {
    std::string key;        // key of an object, or
    std::size_t index = 0;  // index in a list
    bool in_list = false;
};
using JsonPath = std::vector<JsonPathStep>;

// "bodies[2].position.x"; empty for the root.
std::string to_text(const JsonPath& path);

// The inverse, for trusted paths: field names and list indices.
JsonPath parse_json_path(std::string_view path);

// Returns "line 3, column 5: ", where the value begins (from 1, columns in bytes), under its own
// name or the camelCase form; empty if the text, which must be well-formed JSON, has no such value.
std::string position_of(std::string_view text, const JsonPath& path);

}  // namespace jostle::scenes
