// SPDX-License-Identifier: MIT
//
// Against DNS rebinding: a page of a stranger makes its own name point at this server, and the
// browser then takes the two for one site. Its requests still carry the stranger's name in Host.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace jostle::server {

// Does a Host header name this server? IP addresses and localhost do (no page can make them its
// own), and the names allowed; "*" allows all. Without a Host it is no browser that asks.
bool host_is_allowed(std::string_view host_header, const std::vector<std::string>& allowed);

}  // namespace jostle::server
