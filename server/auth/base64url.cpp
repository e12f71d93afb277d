// SPDX-License-Identifier: MIT
#include "server/auth/base64url.h"

#include <cstdint>

namespace jostle::server {

namespace {

// The six bits of a digit; -1: not a base64url digit.
int bits_of(char digit) {
    if (digit >= 'A' && digit <= 'Z') return digit - 'A';
    if (digit >= 'a' && digit <= 'z') return digit - 'a' + 26;
    if (digit >= '0' && digit <= '9') return digit - '0' + 52;
    if (digit == '-') return 62;
    if (digit == '_') return 63;
    return -1;
}

}  // namespace

std::optional<std::string> from_base64url(std::string_view text) {
    if (text.size() % 4 == 1) return std::nullopt;  // six bits do not form a byte
    std::string bytes;
    bytes.reserve(text.size() * 3 / 4);
    std::uint32_t pending = 0;  // bits that are not written yet
    int count = 0;              // number of pending bits
    for (const char digit : text) {
        const int bits = bits_of(digit);
        if (bits < 0) return std::nullopt;
        pending = (pending << 6 | static_cast<std::uint32_t>(bits)) & 0xffff;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(pending >> count & 0xff);
    }
    if ((pending & ((1u << count) - 1)) != 0) return std::nullopt;
    return bytes;
}

}  // namespace jostle::server
