// SPDX-License-Identifier: MIT
//
// Protection against DNS rebinding: an attacker's page resolves its own host name to this server,
// so that the browser treats both as one origin. Its requests still carry the attacker's name in
// Host.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace jostle::server {

// Whether a Host header names this server. IP addresses and localhost do, because no page can claim
// them as its own name; so do the allowed names, and "*" allows all. A request without Host does
// not come from a browser and is allowed.
bool host_is_allowed(std::string_view host_header, const std::vector<std::string>& allowed);

}  // namespace jostle::server
