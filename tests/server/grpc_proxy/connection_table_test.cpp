// SPDX-License-Identifier: MIT
#include "server/grpc_proxy/connection_table.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>

#include <vector>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using Refusal = ConnectionTable::Refusal;

sockaddr_storage from(const char* address, std::uint16_t port) {
    sockaddr_storage peer{};
    auto& four = reinterpret_cast<sockaddr_in&>(peer);
    four.sin_family = AF_INET;
    four.sin_port = htons(port);
    inet_pton(AF_INET, address, &four.sin_addr);
    return peer;
}

const Clock::time_point now = Clock::now();

TEST(ConnectionTable, limits_connections_per_address) {
    ConnectionTable table({.total_max = 4, .per_address_max = 3});
    std::vector<std::shared_ptr<Connection>> open;
    for (std::uint16_t port = 1; port <= 3; port++) {
        ASSERT_FALSE(table.refusal_for(from("192.0.2.1", port), now));
        open.push_back(table.admit(from("192.0.2.1", port)));
    }
    EXPECT_EQ(table.refusal_for(from("192.0.2.1", 4), now), Refusal::address_full);
    EXPECT_FALSE(table.refusal_for(from("192.0.2.2", 4), now));
    open.push_back(table.admit(from("192.0.2.2", 4)));
    EXPECT_EQ(table.refusal_for(from("192.0.2.3", 5), now), Refusal::full);
    table.remove(*open[1]);
    EXPECT_FALSE(table.refusal_for(from("192.0.2.1", 4), now));
    EXPECT_EQ(table.size(), 3u);
}

TEST(ConnectionTable, finds_connections_by_grpc_peer_name) {
    ConnectionTable table({});
    const auto one = table.admit(from("192.0.2.1", 4711)), two = table.admit(from("192.0.2.1", 1));
    EXPECT_EQ(table.of("unix-abstract:" + one->name), one);
    EXPECT_EQ(table.of(two->grpc_name())->peer, "192.0.2.1:1");
    table.remove(*two);
    EXPECT_EQ(table.of(two->grpc_name())->address, "") << "a removed connection has no address";
    EXPECT_EQ(table.of("inproc")->peer, "inproc");
}

TEST(ConnectionTable, trusted_proxies_have_no_limit_per_address_and_no_penalty) {
    const TrustedProxies proxies = TrustedProxies::create({"10.0.0.0/8"}, {}).value();
    ConnectionTable table({.total_max = 5, .per_address_max = 1}, &proxies);
    const auto first = table.admit(from("10.0.0.1", 1));
    EXPECT_TRUE(first->is_proxy);
    EXPECT_FALSE(table.refusal_for(from("10.0.0.1", 2), now));
    table.penalize(*first, now);
    EXPECT_FALSE(table.refusal_for(from("10.0.0.1", 2), now));
    EXPECT_EQ(table.client_address(*first, "6.6.6.6, 203.0.113.9"), "203.0.113.9");
    EXPECT_EQ(table.forwarded_header(), "x-forwarded-for");
    const auto direct = table.admit(from("192.0.2.1", 1));
    EXPECT_EQ(table.client_address(*direct, "203.0.113.9"), "192.0.2.1");
}

TEST(ConnectionTable, counts_the_client_that_a_proxy_named) {
    const TrustedProxies proxies = TrustedProxies::create({"10.0.0.1"}, {}).value();
    ConnectionTable table({.total_max = 9, .per_address_max = 1}, &proxies);
    const auto first = table.admit(from("10.0.0.1", 1)), second = table.admit(from("10.0.0.1", 2));
    EXPECT_FALSE(table.set_client(*first, from("203.0.113.9", 4711), now));
    EXPECT_EQ(first->peer, "203.0.113.9:4711");
    EXPECT_EQ(first->address, "203.0.113.9");
    EXPECT_FALSE(first->is_proxy);
    EXPECT_EQ(table.set_client(*second, from("203.0.113.9", 4712), now), Refusal::address_full);
    EXPECT_EQ(second->address, "10.0.0.1") << "a refused client changes nothing";
    EXPECT_EQ(table.refusal_for(from("203.0.113.9", 1), now), Refusal::address_full);
    table.remove(*first);
    EXPECT_FALSE(table.set_client(*second, from("203.0.113.9", 4712), now));
    table.penalize(*second, now);
    EXPECT_EQ(table.refusal_for(from("203.0.113.9", 1), now), Refusal::address_full);
    table.remove(*second);
    EXPECT_EQ(table.refusal_for(from("203.0.113.9", 1), now), Refusal::address_penalized);
}

TEST(ConnectionTable, penalty_doubles_up_to_one_minute) {
    ConnectionTable table({});
    const auto attacker = table.admit(from("192.0.2.1", 1));
    Clock::time_point t = now;
    for (const auto wait : {1s, 2s, 4s, 8s, 16s, 32s, 60s, 60s}) {
        table.penalize(*attacker, t);
        table.penalize(*attacker, t + wait / 2);  // its other connections belong to the same attack
        EXPECT_EQ(table.refusal_for(from("192.0.2.1", 2), t + wait - 1ms),
                  Refusal::address_penalized);
        EXPECT_FALSE(table.refusal_for(from("192.0.2.2", 2), t))
            << "other addresses must not be penalized";
        t += wait;
        EXPECT_FALSE(table.refusal_for(from("192.0.2.1", 2), t));
    }
    t += 11min;
    table.penalize(*attacker, t);
    EXPECT_FALSE(table.refusal_for(from("192.0.2.1", 2), t + 1s)) << "old penalties must expire";
}

}  // namespace
}  // namespace jostle::server
