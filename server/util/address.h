// SPDX-License-Identifier: MIT
//
// Names and networks of addresses, for limits and logs. Pure functions; any thread.
#pragma once

#include <sys/socket.h>

#include <string>
#include <string_view>

namespace jostle::server {

// The part of an address that one customer of a provider controls: an entire IPv4 address, the
// first 64 bits of an IPv6 address. Limits per address use it. "192.0.2.7" is unchanged,
// "2001:db8::1" becomes "2001:db8::/64", "::ffff:192.0.2.7" becomes "192.0.2.7"; everything else is
// one network, "elsewhere".
std::string network_of(std::string_view address);
std::string network_of(const sockaddr_storage& address);

// "192.0.2.7", "2001:db8::1"; IPv4 also if it is mapped into IPv6.
std::string address_name(const sockaddr_storage& address);
// The same with the port: "192.0.2.7:4711", "[2001:db8::1]:4711".
std::string peer_name(const sockaddr_storage& address);

}  // namespace jostle::server
