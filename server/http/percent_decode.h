// SPDX-License-Identifier: MIT
//
// What a target says in escapes: "%20" is a space.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jostle::server {

// Nothing: an escape is malformed.
std::optional<std::string> percent_decode(std::string_view text);

// The value of a field of a target's query: "world" of "/debug/profile?world=my%20arena&seconds=5"
// is "my arena". Nothing: it is not there, or malformed.
std::optional<std::string> query_field(std::string_view target, std::string_view name);

}  // namespace jostle::server
