// SPDX-License-Identifier: MIT
//
// The origin of a page (RFC 6454): scheme, host and port. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace jostle::server {

struct Origin {
    std::string scheme, host;  // in lower case
    std::uint16_t port = 0;    // 0: the scheme has no default port, and none is given

    bool operator==(const Origin&) const = default;
};

// "https://play.example.org" and "https://Play.example.org:443" are the same origin. Nothing: the
// text is not an origin, as "null", "play.example.org" or "https://play.example.org/".
std::optional<Origin> parse_origin(std::string_view text);

}  // namespace jostle::server
