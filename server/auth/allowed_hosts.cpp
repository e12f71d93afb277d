// SPDX-License-Identifier: MIT
#include "server/auth/allowed_hosts.h"

#include <arpa/inet.h>

#include <algorithm>
#include <cctype>

namespace jostle::server {

namespace {

// Converts "Play.Example.org.:8080" to "play.example.org" and "[::1]:80" to "::1".
std::string name_in(std::string_view host) {
    if (host.starts_with('[')) return std::string(host.substr(1, host.find(']') - 1));
    host = host.substr(0, host.find(':'));
    if (host.ends_with('.')) host.remove_suffix(1);
    std::string name(host);
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name;
}

bool is_address(const std::string& name) {
    unsigned char out[sizeof(in6_addr)];
    return inet_pton(AF_INET, name.c_str(), out) == 1 ||
           inet_pton(AF_INET6, name.c_str(), out) == 1;
}

}  // namespace

bool host_is_allowed(std::string_view host_header, const std::vector<std::string>& allowed) {
    if (host_header.empty()) return true;
    const std::string name = name_in(host_header);
    if (name == "localhost" || is_address(name)) return true;
    return std::ranges::any_of(
        allowed, [&](const std::string& one) { return one == "*" || name_in(one) == name; });
}

}  // namespace jostle::server
