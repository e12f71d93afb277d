// SPDX-License-Identifier: MIT
//
// Strangers' text, made safe to show: names and messages that end up in logs, close reasons and
// answers. Pure functions; any thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace jostle::server {

// The longest beginning of at most so many bytes that cuts no UTF-8 character in two.
std::string_view clip_utf8(std::string_view text, std::size_t bytes_max);

// On one line, clipped: control characters and what is no UTF-8 become \n, \t, \x1b and the like, a
// backslash becomes two.
std::string printable(std::string_view text, std::size_t bytes_max);

// The same between double quotes, of which it has none inside: where it ends is beyond doubt.
std::string quoted(std::string_view text, std::size_t bytes_max = 256);

}  // namespace jostle::server
