// SPDX-License-Identifier: MIT
#include "identity/network_of.h"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <algorithm>

namespace jostle::server {

std::string network_of(std::string_view address) {
    address = address.substr(0, address.find('%'));  // a zone: "fe80::1%eth0"
    const std::string text(address);
    char out[INET6_ADDRSTRLEN];
    in_addr v4;
    if (inet_pton(AF_INET, text.c_str(), &v4) == 1) return inet_ntop(AF_INET, &v4, out, sizeof out);
    in6_addr v6;
    if (inet_pton(AF_INET6, text.c_str(), &v6) != 1) return "elsewhere";
    if (IN6_IS_ADDR_V4MAPPED(&v6)) return inet_ntop(AF_INET, &v6.s6_addr[12], out, sizeof out);
    std::fill(v6.s6_addr + 8, v6.s6_addr + 16, std::uint8_t{0});
    return std::string(inet_ntop(AF_INET6, &v6, out, sizeof out)) + "/64";
}

}  // namespace jostle::server
