// SPDX-License-Identifier: MIT
//
// Base64 in the alphabet of URLs, as tokens and key sets use it (RFC 7515, section 2).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jostle::server {

// Each text has one reading: no padding, no other alphabet, no white space, no bits left over.
// Nothing: it is none.
std::optional<std::string> from_base64url(std::string_view text);

}  // namespace jostle::server
