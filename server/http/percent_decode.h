// SPDX-License-Identifier: MIT
//
// Decodes percent escapes: "%20" is a space.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jostle::server {

// Empty if an escape is malformed.
std::optional<std::string> percent_decode(std::string_view text);

// The value of a query field of a target: "world" of "/debug/profile?world=my%20arena&seconds=5" is
// "my arena". Empty if it is missing or malformed.
std::optional<std::string> query_field(std::string_view target, std::string_view name);

}  // namespace jostle::server
