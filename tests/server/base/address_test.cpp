// SPDX-License-Identifier: MIT
#include "base/address.h"

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

TEST(Address, a_customers_64_bits_are_one_address) {
    EXPECT_EQ(address_key("2001:db8:0:1:aaaa::7"), "2001:db8:0:1::/64");
    EXPECT_EQ(address_key(six("2001:db8:0:1::1", 80)), address_key("2001:db8:0:1:ffff::9%eth0"));
    EXPECT_NE(address_key("2001:db8:0:1::1"), address_key("2001:db8:0:2::1"));
}

TEST(Address, ipv4_is_itself_by_whichever_socket_it_came) {
    EXPECT_EQ(address_key("192.0.2.7"), "192.0.2.7");
    EXPECT_EQ(address_key("::ffff:192.0.2.7"), "192.0.2.7");
    EXPECT_EQ(grpc_peer_name(six("::ffff:192.0.2.7", 4711)), "ipv4:192.0.2.7:4711");
    EXPECT_EQ(grpc_peer_name(six("::1", 4711)), "ipv6:%5B::1%5D:4711");
}

}  // namespace
}  // namespace jostle::server
