// SPDX-License-Identifier: MIT
#include "server/config/exposure.h"

#include <arpa/inet.h>
#include <netinet/in.h>

namespace jostle::server {

namespace {

// The first setting with an address that other machines can reach, as "listen is 0.0.0.0:50051";
// empty: none.
std::string reachable(const Config& config) {
    for (const auto& [key, address] :
         {std::pair("listen", config.listen), std::pair("http", config.http),
          std::pair("admin", config.admin),
          std::pair("datagrams.listen", config.datagrams.listen)}) {
        if (address.empty()) continue;  // disabled
        const Result<HostPort> parsed = parse_host_port(address);
        if (!parsed.ok() || !is_loopback(parsed->host)) return std::string(key) + " is " + address;
    }
    return {};
}

}  // namespace

bool is_loopback(const std::string& host) {
    if (host == "localhost") return true;
    in_addr v4;
    if (inet_pton(AF_INET, host.c_str(), &v4) == 1) return (ntohl(v4.s_addr) >> 24) == 127;
    in6_addr v6;
    return inet_pton(AF_INET6, host.c_str(), &v6) == 1 && IN6_IS_ADDR_LOOPBACK(&v6);
}

Status check_exposure(const Config& config) {
    if (config.insecure) return {};
    const std::string where = reachable(config);
    if (where.empty() && !config.trusted_proxies.empty() && config.auth.keys.empty() &&
        config.auth.anonymous_role.empty())
        return Error{ErrorCode::failed_precondition,
                     "trusted_proxies is set, so other machines can reach this server, without "
                     "auth.keys, auth.issuer and auth.audience; set them "
                     "(docs/guides/operator/secure.md), set auth.anonymous_role to the role of "
                     "clients without a token, or set insecure = true if the proxy authenticates "
                     "them"};
    if (where.empty()) return {};
    std::string missing;
    if (config.tls.certificate.empty()) missing = "tls.certificate and tls.key";
    if (config.auth.keys.empty())
        missing += std::string(missing.empty() ? "" : ", and ") +
                   "auth.keys, auth.issuer and auth.audience";
    if (missing.empty()) return {};
    return Error{ErrorCode::failed_precondition,
                 where + ", which other machines can reach, without " + missing +
                     "; set them (docs/guides/operator/secure.md), listen on 127.0.0.1, or set "
                     "insecure = true if "
                     "a proxy in front of this server provides both"};
}

std::string anonymous_role(const Config& config) {
    if (!config.auth.anonymous_role.empty()) return config.auth.anonymous_role;
    if (!config.auth.keys.empty()) return "none";
    return reachable(config).empty() && config.trusted_proxies.empty() ? "admin" : "director";
}

}  // namespace jostle::server
