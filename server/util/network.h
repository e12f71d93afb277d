// SPDX-License-Identifier: MIT
//
// Networks: addresses that share a prefix, for bans and trusted proxies. Pure functions; any
// thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "jostle/base/result.h"

namespace jostle::server {

// Addresses that share a prefix. IPv4 and IPv6 are separate; IPv4 mapped into IPv6 is IPv4.
struct Network {
    bool is_ipv6 = false;
    std::array<std::uint8_t, 16> address{};  // IPv4: the first 4 bytes; zero beyond the prefix
    int prefix = 0;                          // bits

    auto operator<=>(const Network&) const = default;
};

// "192.0.2.7", "192.0.2.0/24", "2001:db8::/48", "::ffff:192.0.2.7". An IPv6 address without a
// prefix is its /64, which one customer of a provider controls. An address with bits beyond its
// prefix is an error.
Result<Network> parse_network(std::string_view text);
// The same, except that an IPv6 address without a prefix is that address alone.
Result<Network> parse_exact_network(std::string_view text);
// A single address, with its full prefix; nothing: the text is no address.
std::optional<Network> parse_address(std::string_view text);
// The network of the first `prefix` bits of an address.
Network masked(Network network, int prefix);
// Whether an address, as parse_address() returns it, belongs to a network.
bool contains(const Network& network, const Network& address);
// "192.0.2.7", "192.0.2.0/24", "2001:db8::/48".
std::string text_of(const Network& network);
// The address alone: "192.0.2.7", "2001:db8::1".
std::string address_text(const Network& network);

}  // namespace jostle::server
