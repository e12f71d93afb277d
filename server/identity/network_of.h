// SPDX-License-Identifier: MIT
//
// The part of an address that one customer of a provider has to himself: all of an IPv4 address,
// the first 64 bits of an IPv6 one. Limits by address go by it.
#pragma once

#include <string>
#include <string_view>

namespace jostle::server {

// "192.0.2.7" stays, "2001:db8::1" becomes "2001:db8::/64", "::ffff:192.0.2.7" "192.0.2.7".
// Everything else is one network, "elsewhere".
std::string network_of(std::string_view address);

}  // namespace jostle::server
