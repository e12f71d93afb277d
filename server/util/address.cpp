// SPDX-License-Identifier: MIT
#include "server/util/address.h"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <cstring>
#include <optional>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

const in6_addr& ipv6_prefix_of(const sockaddr_storage& address) {
    return reinterpret_cast<const sockaddr_in6&>(address).sin6_addr;
}

// The IPv4 address, also if it is mapped into IPv6.
std::optional<in_addr> ipv4_of(const sockaddr_storage& address) {
    if (address.ss_family == AF_INET) return reinterpret_cast<const sockaddr_in&>(address).sin_addr;
    if (address.ss_family != AF_INET6 || !IN6_IS_ADDR_V4MAPPED(&ipv6_prefix_of(address)))
        return std::nullopt;
    in_addr four{};
    std::memcpy(&four, ipv6_prefix_of(address).s6_addr + 12, 4);
    return four;
}

std::string text_of(int family, const void* address) {
    char text[INET6_ADDRSTRLEN] = {};
    ASSERT(family == AF_INET || family == AF_INET6);
    return inet_ntop(family, address, text, sizeof text) ? text : "unknown";
}

}  // namespace

std::string network_of(const sockaddr_storage& address) {
    if (const auto four = ipv4_of(address)) return text_of(AF_INET, &*four);
    if (address.ss_family != AF_INET6) return "elsewhere";
    in6_addr net = ipv6_prefix_of(address);
    std::memset(net.s6_addr + 8, 0, 8);
    return text_of(AF_INET6, &net) + "/64";
}

std::string network_of(std::string_view address) {
    sockaddr_storage parsed{};
    const std::string text(address.substr(0, address.find('%')));  // without the zone
    auto& four = reinterpret_cast<sockaddr_in&>(parsed);
    auto& six = reinterpret_cast<sockaddr_in6&>(parsed);
    if (inet_pton(AF_INET, text.c_str(), &four.sin_addr) == 1)
        parsed.ss_family = AF_INET;
    else if (inet_pton(AF_INET6, text.c_str(), &six.sin6_addr) == 1)
        parsed.ss_family = AF_INET6;
    return network_of(parsed);
}

std::string address_name(const sockaddr_storage& address) {
    if (const auto four = ipv4_of(address)) return text_of(AF_INET, &*four);
    return address.ss_family == AF_INET6 ? text_of(AF_INET6, &ipv6_prefix_of(address))
                                         : "elsewhere";
}

std::string peer_name(const sockaddr_storage& address) {
    // sockaddr_in and sockaddr_in6 hold the port at the same offset.
    const std::string port =
        std::to_string(ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port));
    const std::string host = address_name(address);
    return (host.find(':') != std::string::npos ? "[" + host + "]" : host) + ":" + port;
}

}  // namespace jostle::server
