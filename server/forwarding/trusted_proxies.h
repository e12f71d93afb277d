// SPDX-License-Identifier: MIT
//
// The proxies whose statements about their clients this server believes, and the address of a
// client behind them. A client can send any header, so only what a trusted proxy appended counts.
// Immutable; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"
#include "server/util/network.h"

namespace jostle::server {

// Only one header is read: a proxy that sets one passes the other on as its client sent it.
enum class ForwardedHeader { x_forwarded_for, forwarded };

class TrustedProxies {
public:
    TrustedProxies() = default;  // none
    // Addresses and networks, as "10.0.0.0/8" or "2001:db8::1".
    static Result<TrustedProxies> create(const std::vector<std::string>& networks,
                                         ForwardedHeader header);

    bool contains(std::string_view address) const;
    // In lower case.
    std::string_view header_name() const;

    // The client of a request that `peer` sent with this value of the header; empty: it is absent.
    // Evaluated from the end: each trusted proxy names the sender from which it received the
    // request, and the first untrusted sender is the client. If a proxy names no valid address, it
    // counts as the client itself.
    std::string client_address(std::string_view peer, std::string_view header_value) const;

private:
    bool contains(const Network& address) const;

    std::vector<Network> networks_;
    ForwardedHeader header_ = ForwardedHeader::x_forwarded_for;
};

}  // namespace jostle::server
