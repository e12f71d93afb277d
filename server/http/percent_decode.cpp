// SPDX-License-Identifier: MIT
#include "server/http/percent_decode.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

std::optional<std::string> percent_decode(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded += text[i];
            continue;
        }
        if (i + 2 >= text.size()) return std::nullopt;
        const int high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
        if (high < 0 || low < 0) return std::nullopt;
        ASSERT(high < 16 && low < 16);
        decoded += static_cast<char>(high * 16 + low);
        i += 2;
    }
    ASSERT(decoded.size() <= text.size());
    return decoded;
}

std::optional<std::string> query_field(std::string_view target, std::string_view name) {
    const std::size_t mark = target.find('?');
    if (mark == std::string_view::npos) return std::nullopt;
    std::string_view rest = target.substr(mark + 1);
    while (!rest.empty()) {
        const std::string_view field = rest.substr(0, rest.find('&'));
        rest.remove_prefix(std::min(rest.size(), field.size() + 1));
        const std::size_t equals = field.find('=');
        if (equals == std::string_view::npos || field.substr(0, equals) != name) continue;
        return percent_decode(field.substr(equals + 1));
    }
    return std::nullopt;
}

}  // namespace jostle::server
