// SPDX-License-Identifier: MIT
#include "server/util/socket.h"
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

namespace jostle::server {

TEST(BoundSocket, port_0_selects_a_free_port_that_is_then_in_use) {
    const auto first = open_bound_socket("127.0.0.1", 0, SOCK_DGRAM);
    ASSERT_TRUE(first.ok()) << first.error().message;
    const std::uint16_t port = port_of(*first);
    EXPECT_GT(port, 0);
    const auto second = open_bound_socket("127.0.0.1", port, SOCK_DGRAM);
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().message, "Address already in use");
    close(*first);
}

TEST(BoundSocket, rejects_an_address_of_another_machine) {
    EXPECT_FALSE(open_bound_socket("192.0.2.1", 0, SOCK_STREAM).ok());
    EXPECT_FALSE(open_bound_socket("no host", 0, SOCK_STREAM).ok());
}

}  // namespace jostle::server
