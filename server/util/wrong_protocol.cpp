// SPDX-License-Identifier: MIT
#include "server/util/wrong_protocol.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace jostle::server {

namespace {

// An alert of level fatal: handshake_failure (RFC 8446, 6), in a record of TLS 1.0, which every
// client reads.
constexpr std::string_view tls_alert("\x15\x03\x01\0\x02\x02\x28", 7);

}  // namespace

FirstBytes protocol_of(std::span<const std::uint8_t> first_bytes) {
    constexpr std::uint8_t tls_handshake = 0x16;
    if (first_bytes.empty()) return FirstBytes::unknown;
    if (first_bytes[0] == tls_handshake) return FirstBytes::tls;
    const std::string_view text(reinterpret_cast<const char*>(first_bytes.data()),
                                first_bytes.size());
    if (text.starts_with("PRI")) return FirstBytes::http2;
    const std::string_view method = text.substr(0, text.find(' '));
    const bool is_method = std::ranges::all_of(method, [](char c) { return c >= 'A' && c <= 'Z'; });
    return is_method && !method.empty() ? FirstBytes::http1 : FirstBytes::unknown;
}

std::string wrong_protocol_reply(FirstBytes protocol, std::string_view hint) {
    switch (protocol) {
        case FirstBytes::tls:
            return std::string(tls_alert);
        case FirstBytes::http1:
        case FirstBytes::http2:
            return fmt::format(
                "HTTP/1.1 400 Bad Request\r\nContent-Type: text/plain; charset=utf-8\r\n"
                "Content-Length: {}\r\nConnection: close\r\n\r\n{}\n",
                hint.size() + 1, hint);
        case FirstBytes::unknown:
            break;
    }
    return {};
}

}  // namespace jostle::server
