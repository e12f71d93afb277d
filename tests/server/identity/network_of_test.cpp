// SPDX-License-Identifier: MIT
#include "identity/network_of.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(NetworkOf, an_ipv4_address_is_one_and_an_ipv6_one_stands_for_its_64) {
    EXPECT_EQ(network_of("192.0.2.7"), "192.0.2.7");
    EXPECT_EQ(network_of("2001:db8:1:2:3:4:5:6"), "2001:db8:1:2::/64");
    EXPECT_EQ(network_of("2001:db8:1:2:ffff::1"), "2001:db8:1:2::/64");
    EXPECT_EQ(network_of("::1"), "::/64");
    EXPECT_EQ(network_of("::ffff:192.0.2.7"), "192.0.2.7") << "one person, two spellings";
    EXPECT_EQ(network_of("fe80::1%eth0"), "fe80::/64");
}

TEST(NetworkOf, everything_else_is_one_network) {
    for (const char* text : {"", "unix:/tmp/socket", "1.2.3", "1.2.3.4:80", "[::1]", "example.org"})
        EXPECT_EQ(network_of(text), "elsewhere") << text;
}

}  // namespace
}  // namespace jostle::server
