// SPDX-License-Identifier: MIT
#include "server/limits/connected_clients.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"

namespace jostle::server {

using namespace std::chrono_literals;
using test::error_of;

namespace {

const Clock::time_point arrival{100s};

ClientIdentity client(ClientId id) {
    return {.id = id,
            .name = "ann",
            .subject = {},
            .world_id = "w1",
            .world_name = "arena",
            .address = "ipv4:10.0.0.1:4000",
            .since = arrival};
}

// 60 messages of 250 bytes per second are 120 kbit/s at any time.
TEST(ConnectedClientsTest, reports_the_rate_of_the_last_second) {
    ConnectedClients connected_clients;
    const auto record = connected_clients.add(client(7));
    Clock::time_point now = arrival;
    for (int i = 1; i <= 600; i++) {
        now = arrival + i * 16667us;
        record->count_sent(250, now);
        if (i < 30) continue;
        EXPECT_NEAR(connected_clients.status(now)[0].kbit_per_second, 120, 6) << i;
    }
    // No more messages are sent, so the rate falls.
    EXPECT_LT(connected_clients.status(now + 60s)[0].kbit_per_second, 2);
    EXPECT_NEAR(connected_clients.status(now + 60s)[0].connected_seconds, 70, 0.1);
}

TEST(ConnectedClientsTest, lists_clients_by_id) {
    ConnectedClients connected_clients;
    const auto nine = connected_clients.add(client(9)), two = connected_clients.add(client(2));
    nine->set_flow(14, 0.025);
    const auto sights = connected_clients.status(arrival + 3s);
    ASSERT_EQ(sights.size(), 2u);
    EXPECT_EQ(sights[0].who.id, 2u);
    EXPECT_EQ(sights[1].who.id, 9u);
    EXPECT_EQ(sights[1].skipped, 14u);
    EXPECT_DOUBLE_EQ(sights[1].round_trip_ms, 25);
    connected_clients.remove(9);
    EXPECT_EQ(connected_clients.status(arrival).size(), 1u);
}

TEST(ConnectedClientsTest, kick_stores_the_reason) {
    ConnectedClients connected_clients;
    const auto record = connected_clients.add(client(3));
    EXPECT_FALSE(record->kicked());
    EXPECT_TRUE(connected_clients.kick(3, "flooding", {}).ok());
    EXPECT_EQ(record->kicked(), "flooding");
    connected_clients.remove(3);
    EXPECT_EQ(error_of(connected_clients.kick(3, "again", {})).code, ErrorCode::not_found);
}

}  // namespace
}  // namespace jostle::server
