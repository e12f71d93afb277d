// SPDX-License-Identifier: MIT
//
// Where a value stands in a JSON text: the steps from the whole down to it. Keys are foreign and
// may hold anything, so they are kept apart and only joined to be shown.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace jostle::scenes {

struct JsonPathStep {
    std::string key;        // of an object, or
    std::size_t index = 0;  // the place in a list
    bool in_list = false;
};
using JsonPath = std::vector<JsonPathStep>;

// "bodies[2].position.x"; empty for the whole.
std::string to_text(const JsonPath& place);

// The reverse, for paths of our own making: field names and places in lists.
JsonPath parse_json_path(std::string_view path);

// The line (from 1) on which the value begins, under its own name or the camelCase form of it; 0
// when the text, which must be well-formed JSON, has no such value.
int line_of(std::string_view text, const JsonPath& place);

}  // namespace jostle::scenes
