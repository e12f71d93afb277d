// SPDX-License-Identifier: MIT
#include "server/util/network.h"

#include <gtest/gtest.h>

#include <utility>

namespace jostle::server {
namespace {

TEST(Network, parses_addresses_and_prefixes) {
    for (const auto& [text, expected] :
         {std::pair("192.0.2.7", "192.0.2.7"), std::pair("192.0.2.7/32", "192.0.2.7"),
          std::pair("192.0.2.0/24", "192.0.2.0/24"), std::pair("0.0.0.0/0", "0.0.0.0/0"),
          std::pair("2001:DB8:0:0::/48", "2001:db8::/48"), std::pair("::/0", "::/0"),
          std::pair("2001:db8::1", "2001:db8::/64"),
          std::pair("2001:db8::1/128", "2001:db8::1/128"),
          std::pair("::ffff:192.0.2.7", "192.0.2.7"),
          std::pair("::ffff:192.0.2.0/120", "192.0.2.0/24")}) {
        const Result<Network> network = parse_network(text);
        ASSERT_TRUE(network.ok()) << text << network.error().message;
        EXPECT_EQ(text_of(*network), expected);
    }
    for (const char* text :
         {"", "anna", "192.0.2", "192.0.2.7/", "192.0.2.0/33", "192.0.2.0/-1", "192.0.2.0/24x",
          "192.0.2.0/ 24", "192.0.2.7/24", "2001:db8::1/48", "2001:db8::/129", "fe80::1%eth0",
          "::ffff:192.0.2.0/24", "192.0.2.0/24/8", "[2001:db8::1]"})
        EXPECT_FALSE(parse_network(text).ok()) << text;
    EXPECT_NE(parse_network("192.0.2.7/24").error().message.find("the network is 192.0.2.0/24"),
              std::string::npos);
}

TEST(Network, contains_addresses_with_its_prefix_and_family) {
    const Network ten = parse_network("10.0.0.0/8").value();
    EXPECT_TRUE(contains(ten, *parse_address("10.255.0.1")));
    EXPECT_TRUE(contains(ten, *parse_address("::ffff:10.0.0.1")));
    EXPECT_FALSE(contains(ten, *parse_address("11.0.0.1")));
    EXPECT_FALSE(contains(ten, *parse_address("a00::1"))) << "the same bits, but IPv6";
    EXPECT_TRUE(contains(parse_network("::/0").value(), *parse_address("2001:db8::1")));
    EXPECT_FALSE(contains(parse_network("::/0").value(), *parse_address("10.0.0.1")));
}

TEST(Network, an_exact_address_has_its_full_prefix) {
    EXPECT_EQ(text_of(parse_exact_network("2001:db8::1").value()), "2001:db8::1/128");
    EXPECT_EQ(text_of(parse_exact_network("2001:db8::/32").value()), "2001:db8::/32");
    EXPECT_EQ(text_of(parse_exact_network("192.0.2.7").value()), "192.0.2.7");
    EXPECT_FALSE(parse_exact_network("proxy").ok());
    EXPECT_EQ(address_text(*parse_address("2001:DB8::1")), "2001:db8::1");
    EXPECT_FALSE(parse_address(std::string_view("10.0.0.1\0", 9)));
}

}  // namespace
}  // namespace jostle::server
