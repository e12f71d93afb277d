// SPDX-License-Identifier: MIT
//
// The addresses in the headers that proxies add: X-Forwarded-For and Forwarded (RFC 7239). Each
// proxy appends the address from which it received the request, so the first entry is the client's,
// as far as the proxies can be trusted (trusted_proxies.h). Pure functions; any thread.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "server/util/network.h"

namespace jostle::server {

// The entries in the order of the header. An entry is empty if it has no address: "unknown", a name
// that hides the address ("_a1"), or malformed text.
using ForwardedAddresses = std::vector<std::optional<Network>>;

// "192.0.2.7, 2001:db8::1". Also accepts a port, "192.0.2.7:4711" or "[2001:db8::1]:4711", as some
// proxies write it. Several header lines are joined with commas.
ForwardedAddresses parse_x_forwarded_for(std::string_view value);

// "for=192.0.2.7;proto=https, for=\"[2001:db8::1]:4711\"". Nothing: the header is malformed, so
// that the end of each entry is uncertain.
std::optional<ForwardedAddresses> parse_forwarded(std::string_view value);

}  // namespace jostle::server
