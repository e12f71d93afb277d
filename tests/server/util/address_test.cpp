// SPDX-License-Identifier: MIT
#include "server/util/address.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>

namespace jostle::server {
namespace {

sockaddr_storage six(const char* text, std::uint16_t port) {
    sockaddr_storage out{};
    auto& address = reinterpret_cast<sockaddr_in6&>(out);
    address.sin6_family = AF_INET6;
    address.sin6_port = htons(port);
    EXPECT_EQ(inet_pton(AF_INET6, text, &address.sin6_addr), 1);
    return out;
}

TEST(Address, ipv4_counts_individually_and_ipv6_by_64_bit_prefix) {
    EXPECT_EQ(network_of("192.0.2.7"), "192.0.2.7");
    EXPECT_EQ(network_of("2001:db8:1:2:3:4:5:6"), "2001:db8:1:2::/64");
    EXPECT_EQ(network_of(six("2001:db8:1:2:ffff::1", 80)), "2001:db8:1:2::/64");
    EXPECT_EQ(network_of("::1"), "::/64");
    EXPECT_EQ(network_of("::ffff:192.0.2.7"), "192.0.2.7")
        << "both notations mean the same address";
    EXPECT_EQ(network_of("fe80::1%eth0"), "fe80::/64");
}

TEST(Address, other_addresses_form_one_network) {
    for (const char* text : {"", "unix:/tmp/socket", "1.2.3", "1.2.3.4:80", "[::1]", "example.org"})
        EXPECT_EQ(network_of(text), "elsewhere") << text;
}

TEST(Address, peer_names_include_the_port) {
    EXPECT_EQ(peer_name(six("::ffff:192.0.2.7", 4711)), "192.0.2.7:4711");
    EXPECT_EQ(peer_name(six("::1", 4711)), "[::1]:4711");
    EXPECT_EQ(address_name(six("::ffff:192.0.2.7", 4711)), "192.0.2.7");
    EXPECT_EQ(address_name(six("::1", 4711)), "::1");
}

}  // namespace
}  // namespace jostle::server
