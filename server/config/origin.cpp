// SPDX-License-Identifier: MIT
#include "server/config/origin.h"

#include <algorithm>
#include <charconv>

namespace jostle::server {

namespace {

std::string lower(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return out;
}

bool is_scheme(std::string_view text) {
    const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
    return !text.empty() && is_letter(text[0]) && std::ranges::all_of(text, [&](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
    });
}

std::uint16_t default_port(std::string_view scheme) {
    if (scheme == "https" || scheme == "wss") return 443;
    return scheme == "http" || scheme == "ws" ? 80 : 0;
}

}  // namespace

std::optional<Origin> parse_origin(std::string_view text) {
    const std::size_t end = text.find("://");
    if (end == std::string_view::npos) return std::nullopt;
    Origin origin{.scheme = lower(text.substr(0, end)), .host = lower(text.substr(end + 3))};
    if (!is_scheme(origin.scheme)) return std::nullopt;
    origin.port = default_port(origin.scheme);
    const std::size_t bracket = origin.host.starts_with('[') ? origin.host.find(']') : 0;
    if (bracket == std::string::npos) return std::nullopt;
    if (const std::size_t colon = origin.host.find(':', bracket); colon != std::string::npos) {
        const std::string_view digits = std::string_view(origin.host).substr(colon + 1);
        const char* const last = digits.data() + digits.size();
        // An empty port is the default port (RFC 3986, 3.2.3).
        if (!digits.empty()) {
            const auto [stop, error] = std::from_chars(digits.data(), last, origin.port);
            if (error != std::errc{} || stop != last || origin.port == 0) return std::nullopt;
        }
        origin.host.resize(colon);
    }
    if (origin.host.empty() || origin.host.find_first_of("/?#@ \t") != std::string::npos)
        return std::nullopt;
    return origin;
}

}  // namespace jostle::server
