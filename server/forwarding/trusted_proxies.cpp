// SPDX-License-Identifier: MIT
#include "server/forwarding/trusted_proxies.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include "server/forwarding/forwarded_headers.h"

namespace jostle::server {

Result<TrustedProxies> TrustedProxies::create(const std::vector<std::string>& networks,
                                              ForwardedHeader header) {
    TrustedProxies proxies;
    proxies.header_ = header;
    for (const std::string& text : networks) {
        const Result<Network> network = parse_exact_network(text);
        if (!network.ok()) return network.error();
        proxies.networks_.push_back(*network);
    }
    return proxies;
}

bool TrustedProxies::contains(const Network& address) const {
    return std::ranges::any_of(
        networks_, [&](const Network& network) { return server::contains(network, address); });
}

bool TrustedProxies::contains(std::string_view address) const {
    if (networks_.empty()) return false;
    // Without the zone of a link-local address.
    const auto parsed = parse_address(address.substr(0, address.find('%')));
    return parsed && contains(*parsed);
}

std::string_view TrustedProxies::header_name() const {
    return header_ == ForwardedHeader::forwarded ? "forwarded" : "x-forwarded-for";
}

std::string TrustedProxies::client_address(std::string_view peer,
                                           std::string_view header_value) const {
    if (header_value.empty() || !contains(peer)) return std::string(peer);
    const ForwardedAddresses chain =
        header_ == ForwardedHeader::forwarded
            ? parse_forwarded(header_value).value_or(ForwardedAddresses{})
            : parse_x_forwarded_for(header_value);
    std::string client(peer);
    for (const std::optional<Network>& sender : chain | std::views::reverse) {
        if (!sender) break;
        client = address_text(*sender);
        if (!contains(*sender)) break;
    }
    return client;
}

}  // namespace jostle::server
