// SPDX-License-Identifier: MIT
#include "server/forwarding/trusted_proxies.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TrustedProxies trusting(const std::vector<std::string>& networks,
                        ForwardedHeader header = ForwardedHeader::x_forwarded_for) {
    return TrustedProxies::create(networks, header).value();
}

TEST(TrustedProxies, ignores_headers_of_untrusted_senders) {
    const TrustedProxies none, proxies = trusting({"10.0.0.0/8"});
    EXPECT_EQ(none.client_address("10.0.0.1", "203.0.113.9"), "10.0.0.1");
    EXPECT_EQ(proxies.client_address("192.0.2.1", "203.0.113.9"), "192.0.2.1");
    EXPECT_EQ(proxies.client_address("10.0.0.1", ""), "10.0.0.1");
    EXPECT_EQ(proxies.client_address("10.0.0.1", "203.0.113.9"), "203.0.113.9");
}

TEST(TrustedProxies, takes_the_last_untrusted_entry_and_not_what_the_client_wrote) {
    const TrustedProxies proxies = trusting({"10.0.0.0/8", "2001:db8::5"});
    // The client wrote 6.6.6.6; the edge proxy appended 203.0.113.9, the next one 10.0.0.2.
    EXPECT_EQ(proxies.client_address("10.0.0.1", "6.6.6.6, 203.0.113.9, 10.0.0.2"), "203.0.113.9");
    EXPECT_EQ(proxies.client_address("2001:db8::5", "6.6.6.6, 203.0.113.9"), "203.0.113.9");
    EXPECT_EQ(proxies.client_address("2001:db8::6", "203.0.113.9"), "2001:db8::6")
        << "an address without a prefix is that address alone";
    // Every sender is a proxy: a client inside of the network of the proxies.
    EXPECT_EQ(proxies.client_address("10.0.0.1", "10.0.0.9, 10.0.0.2"), "10.0.0.9");
    EXPECT_EQ(proxies.client_address("::ffff:10.0.0.1", "203.0.113.9"), "203.0.113.9");
}

TEST(TrustedProxies, a_proxy_that_names_no_address_counts_as_the_client) {
    const TrustedProxies proxies = trusting({"10.0.0.0/8"});
    EXPECT_EQ(proxies.client_address("10.0.0.1", "6.6.6.6, unknown"), "10.0.0.1");
    EXPECT_EQ(proxies.client_address("10.0.0.1", "6.6.6.6, unknown, 10.0.0.2"), "10.0.0.2");
    EXPECT_EQ(proxies.client_address("10.0.0.1", "nonsense"), "10.0.0.1");
}

TEST(TrustedProxies, reads_only_the_configured_header) {
    const TrustedProxies proxies = trusting({"10.0.0.1"}, ForwardedHeader::forwarded);
    EXPECT_EQ(proxies.header_name(), "forwarded");
    EXPECT_EQ(trusting({}).header_name(), "x-forwarded-for");
    EXPECT_EQ(proxies.client_address("10.0.0.1", "for=6.6.6.6, for=\"[2001:db8::7]:1\""),
              "2001:db8::7");
    EXPECT_EQ(proxies.client_address("10.0.0.1", "203.0.113.9"), "10.0.0.1") << "malformed";
}

TEST(TrustedProxies, errors_name_the_wrong_network) {
    const auto bad = TrustedProxies::create({"10.0.0.0/8", "10.0.0.1/8"}, {});
    ASSERT_FALSE(bad.ok());
    EXPECT_NE(bad.error().message.find("\"10.0.0.1/8\""), std::string::npos) << bad.error().message;
}

}  // namespace
}  // namespace jostle::server
