// SPDX-License-Identifier: MIT
//
// Makes text from clients safe to display: names and messages in logs, close reasons and responses.
// Pure functions; any thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace jostle::server {

// The longest prefix of at most `bytes_max` bytes that does not split a UTF-8 character.
std::string_view clip_utf8(std::string_view text, std::size_t bytes_max);

// One clipped line: control characters and invalid UTF-8 become \n, \t, \x1b and so on; a backslash
// becomes two.
std::string printable(std::string_view text, std::size_t bytes_max);

// The same in double quotes. Quotes inside are escaped, so that the end is unambiguous.
std::string in_quotes(std::string_view text, std::size_t bytes_max = 256);

// Whether text contains a character that printable() escapes, other than a backslash: a control
// character, a line separator, a mark that changes the direction of text, or invalid UTF-8.
bool has_control_character(std::string_view text);

}  // namespace jostle::server
