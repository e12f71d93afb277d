// SPDX-License-Identifier: MIT
#include "server/forwarding/proxy_protocol.h"

#include <netinet/in.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

constexpr std::size_t start_bytes = 16;
constexpr std::size_t command_at = 12, family_at = 13, length_at = 14;
constexpr std::string_view signature("\r\n\r\n\0\r\nQUIT\n", 12);
constexpr std::uint8_t version_2 = 0x20, local = 0x20, proxied = 0x21;
constexpr std::uint8_t tcp_over_ipv4 = 0x11, tcp_over_ipv6 = 0x21;
// Source and destination address, source and destination port.
constexpr std::size_t ipv4_bytes = 12, ipv6_bytes = 36;

std::size_t length_in(std::span<const std::uint8_t> start) {
    return static_cast<std::size_t>(start[length_at] << 8 | start[length_at + 1]);
}

}  // namespace

std::size_t ProxyHeaderReader::wanted() const {
    if (received_ < start_bytes) return start_bytes - received_;
    return start_bytes + length_in(bytes_) - received_;
}

Status ProxyHeaderReader::take(std::span<const std::uint8_t> bytes) {
    ASSERT(bytes.size() <= wanted());
    for (const std::uint8_t byte : bytes) {
        if (received_ < signature.size() && byte != static_cast<std::uint8_t>(signature[received_]))
            return invalid_argument(
                byte == 'P' && received_ == 0
                    ? "this is not PROXY protocol version 2, but probably version 1; configure the "
                      "proxy to send version 2"
                    : "this is not PROXY protocol version 2; the setting proxy_protocol requires "
                      "it from this address");
        if (received_ < bytes_.size()) bytes_[received_] = byte;
        if (++received_ != start_bytes) continue;
        if (Status s = check_start(); !s.ok()) return s;
    }
    return {};
}

// Checks the first 16 bytes.
Status ProxyHeaderReader::check_start() const {
    const std::uint8_t command = bytes_[command_at], family = bytes_[family_at];
    const std::size_t length = length_in(bytes_);
    if ((command & 0xf0) != version_2 || (command != local && command != proxied))
        return invalid_argument(fmt::format(
            "the PROXY header has version and command {:#04x}; 0x20 and 0x21 are supported",
            command));
    if (length > rest_bytes_max)
        return invalid_argument(fmt::format("the PROXY header has {} bytes; at most {} are allowed",
                                            length, rest_bytes_max));
    if (command == local) return {};
    const std::size_t least = family == tcp_over_ipv4   ? ipv4_bytes
                              : family == tcp_over_ipv6 ? ipv6_bytes
                                                        : 0;
    if (length < least)
        return invalid_argument(fmt::format(
            "the PROXY header has {} bytes; its addresses need at least {}", length, least));
    return {};
}

std::optional<sockaddr_storage> ProxyHeaderReader::client() const {
    ASSERT(wanted() == 0);
    if (bytes_[command_at] == local) return std::nullopt;
    sockaddr_storage client{};
    const std::uint8_t* const addresses = bytes_.data() + start_bytes;
    if (bytes_[family_at] == tcp_over_ipv4) {
        auto& four = reinterpret_cast<sockaddr_in&>(client);
        four.sin_family = AF_INET;
        std::memcpy(&four.sin_addr, addresses, 4);
        std::memcpy(&four.sin_port, addresses + 8, 2);
        return client;
    }
    if (bytes_[family_at] == tcp_over_ipv6) {
        auto& six = reinterpret_cast<sockaddr_in6&>(client);
        six.sin6_family = AF_INET6;
        std::memcpy(&six.sin6_addr, addresses, 16);
        std::memcpy(&six.sin6_port, addresses + 32, 2);
        return client;
    }
    return std::nullopt;
}

}  // namespace jostle::server
