// SPDX-License-Identifier: MIT
//
// What counts as one address where clients are counted: an IPv4 address, or the 64 bits of an IPv6
// address that one customer has. Pure functions; any thread.
#pragma once

#include <sys/socket.h>

#include <string>

namespace jostle::server {

// "127.0.0.1", "2001:db8:0:1::/64"; an IPv4 address that came by an IPv6 socket is one of IPv4.
std::string address_key(const sockaddr_storage& address);
// Of an address as text; what is none stays as it is.
std::string address_key(const std::string& address);
// As gRPC names a peer: "ipv4:127.0.0.1:4711", "ipv6:%5B::1%5D:4711".
std::string grpc_peer_name(const sockaddr_storage& address);

}  // namespace jostle::server
