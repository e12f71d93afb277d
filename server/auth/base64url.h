// SPDX-License-Identifier: MIT
//
// Base64 in the URL-safe alphabet, as in tokens and key sets (RFC 7515, section 2).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jostle::server {

// Decodes strictly, so that each text has one reading: no padding, no other alphabet, no white
// space, no bits left over. Empty if the text is not valid.
std::optional<std::string> from_base64url(std::string_view text);

}  // namespace jostle::server
