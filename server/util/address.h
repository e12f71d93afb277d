// SPDX-License-Identifier: MIT
//
// Addresses as they are counted and named. Pure functions; any thread.
#pragma once

#include <sys/socket.h>

#include <string>
#include <string_view>

namespace jostle::server {

// The part of an address that one customer of a provider has to himself: all of an IPv4 address,
// the first 64 bits of an IPv6 one. Limits by address go by it. "192.0.2.7" stays, "2001:db8::1"
// becomes "2001:db8::/64", "::ffff:192.0.2.7" "192.0.2.7"; all else is one network, "elsewhere".
std::string network_of(std::string_view address);
std::string network_of(const sockaddr_storage& address);

// "192.0.2.7", "2001:db8::1"; IPv4 also when it came by an IPv6 socket.
std::string address_name(const sockaddr_storage& address);
// The same with its port: "192.0.2.7:4711", "[2001:db8::1]:4711".
std::string peer_name(const sockaddr_storage& address);

}  // namespace jostle::server
