// SPDX-License-Identifier: MIT
//
// Input that names the client of a connection or a request: PROXY headers in pieces,
// X-Forwarded-For, Forwarded, origins and the first bytes of a connection.
#include <algorithm>

#include "server/config/origin.h"
#include "server/forwarding/forwarded_headers.h"
#include "server/forwarding/proxy_protocol.h"
#include "server/forwarding/trusted_proxies.h"
#include "server/util/address.h"
#include "server/util/wrong_protocol.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

// The client, "none", "incomplete" or "refused".
std::string read_proxy_header(Bytes input, std::size_t piece) {
    server::ProxyHeaderReader reader;
    while (reader.wanted() > 0) {
        const std::size_t size = std::min({piece, input.size(), reader.wanted()});
        if (size == 0) return "incomplete";
        if (const Status s = reader.take(input.first(size)); !s.ok()) {
            expect(!s.error().message.empty(), "a refusal has a reason");
            return "refused";
        }
        input = input.subspan(size);
    }
    const auto client = reader.client();
    return client ? server::peer_name(*client) : "none";
}

void check_forwarded(const std::string& value) {
    static const auto proxies = {
        server::TrustedProxies::create({"10.0.0.0/8"}, server::ForwardedHeader::forwarded).value(),
        server::TrustedProxies::create({"10.0.0.0/8"}, server::ForwardedHeader::x_forwarded_for)
            .value()};
    for (const server::TrustedProxies& trusted : proxies) {
        expect(trusted.client_address("192.0.2.1", value) == "192.0.2.1",
               "an untrusted sender names nobody else");
        const std::string client = trusted.client_address("10.0.0.1", value);
        expect(server::parse_address(client).has_value(), "a client has an address");
        // Only text that a trusted proxy appended changes the result.
        if (const auto all = server::parse_forwarded(value); all && !value.empty())
            expect(trusted.header_name() != "forwarded" ||
                       trusted.client_address("10.0.0.1", value + ", for=203.0.113.9") ==
                           "203.0.113.9",
                   "the last entry is the proxy's own");
        if (trusted.header_name() != "forwarded")
            expect(trusted.client_address("10.0.0.1", value + ",203.0.113.9") == "203.0.113.9",
                   "the last entry is the proxy's own");
    }
}

}  // namespace

void run(Bytes input) {
    const std::string whole = read_proxy_header(input, input.size() + 1);
    for (const std::size_t piece : {1, 7})
        expect(read_proxy_header(input, piece) == whole, "how bytes are cut makes no difference");
    const std::string text(text_of(input));
    check_forwarded(text);
    if (const auto origin = server::parse_origin(text)) {
        expect(!origin->host.empty() && !origin->scheme.empty(), "an origin is complete");
        const std::string again =
            origin->scheme + "://" + origin->host +
            (origin->port > 0 ? ":" + std::to_string(origin->port) : std::string());
        expect(server::parse_origin(again) == origin, "an origin is read as it is written");
    }
    const server::FirstBytes protocol = server::protocol_of(input);
    expect(server::wrong_protocol_reply(protocol, "hint").empty() ==
               (protocol == server::FirstBytes::unknown),
           "each known protocol has a reply");
}

}  // namespace jostle::fuzz
