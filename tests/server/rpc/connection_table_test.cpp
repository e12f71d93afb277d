// SPDX-License-Identifier: MIT
//
// Real sockets on the loopback device, counted and measured.
#include "rpc/connection_table.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "base/address.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

class ConnectionTableTest : public testing::Test {
protected:
    struct Pair {
        int client = -1, server = -1;
        sockaddr_storage peer{};
    };

    void SetUp() override {
        listener_ = socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in any{.sin_family = AF_INET, .sin_addr = {htonl(INADDR_LOOPBACK)}};
        ASSERT_EQ(bind(listener_, reinterpret_cast<sockaddr*>(&any), sizeof any), 0);
        ASSERT_EQ(listen(listener_, 64), 0);
    }
    void TearDown() override {
        for (const int descriptor : open_) close(descriptor);
        close(listener_);
    }
    Pair connect_one() {
        sockaddr_storage to{};
        socklen_t size = sizeof to;
        getsockname(listener_, reinterpret_cast<sockaddr*>(&to), &size);
        Pair pair{.client = socket(AF_INET, SOCK_STREAM, 0)};
        EXPECT_EQ(connect(pair.client, reinterpret_cast<sockaddr*>(&to), size), 0);
        size = sizeof pair.peer;
        pair.server = accept(listener_, reinterpret_cast<sockaddr*>(&pair.peer), &size);
        open_.insert(open_.end(), {pair.client, pair.server});
        return pair;
    }
    static void send(const Pair& pair, std::size_t bytes) {
        const std::string data(bytes, 'x');
        std::string sink(1 << 16, '\0');
        for (std::size_t sent = 0; sent < bytes;) {
            const ssize_t n =
                ::send(pair.client, data.data() + sent, bytes - sent, MSG_DONTWAIT | MSG_NOSIGNAL);
            if (n < 0 && errno != EAGAIN) return;  // cut
            if (n > 0) sent += static_cast<std::size_t>(n);
            while (recv(pair.server, sink.data(), sink.size(), MSG_DONTWAIT) > 0) {
            }
        }
    }
    static bool is_cut(const Pair& pair) {
        char c = 0;
        return recv(pair.client, &c, 1, MSG_DONTWAIT) == 0;
    }

    int listener_ = -1;
    std::vector<int> open_;
};

TEST_F(ConnectionTableTest, more_than_the_limit_of_one_address_are_refused_until_one_goes) {
    ConnectionTable table({.total_max = 100, .per_address_max = 3});
    std::vector<Pair> pairs;
    for (int i = 0; i < 4; i++) pairs.push_back(connect_one());
    for (int i = 0; i < 3; i++)
        EXPECT_FALSE(table.admit(pairs[static_cast<std::size_t>(i)].server,
                                 pairs[static_cast<std::size_t>(i)].peer));
    EXPECT_EQ(table.admit(pairs[3].server, pairs[3].peer), ConnectionTable::Refusal::address_full);
    // gRPC closes one and says nothing: its descriptor is found to be another's, or nobody's.
    close(pairs[1].server);
    std::erase(open_, pairs[1].server);
    EXPECT_FALSE(table.admit(pairs[3].server, pairs[3].peer));
    EXPECT_EQ(table.size(), 3u);
    ConnectionTable small({.total_max = 1});
    EXPECT_FALSE(small.admit(pairs[0].server, pairs[0].peer));
    EXPECT_EQ(small.admit(pairs[2].server, pairs[2].peer), ConnectionTable::Refusal::full);
}

TEST_F(ConnectionTableTest, who_sends_what_becomes_no_message_is_cut_and_who_plays_is_not) {
    ConnectionTable table({.unread_bytes_max = 1e6, .unread_total_max = 1e9});
    const Pair flood = connect_one(), player = connect_one();
    ASSERT_FALSE(table.admit(flood.server, flood.peer));
    ASSERT_FALSE(table.admit(player.server, player.peer));
    const auto meter = table.find(grpc_peer_name(player.peer));
    ASSERT_TRUE(meter);
    Clock::time_point now = Clock::now();
    for (int i = 0; i < 12; i++) {
        send(flood, 100'000);
        send(player, 100'000);
        meter->consumed += 100'000;
        table.sweep(now += 200ms);
    }
    EXPECT_TRUE(is_cut(flood));
    EXPECT_EQ(table.cut(), 1u);
    send(player, 10);  // still open
}

TEST_F(ConnectionTableTest, when_there_is_no_more_room_in_all_the_largest_is_cut) {
    ConnectionTable table({.unread_bytes_max = 4e6, .unread_total_max = 5e6});
    std::vector<Pair> pairs;
    for (int i = 0; i < 3; i++) {
        pairs.push_back(connect_one());
        ASSERT_FALSE(table.admit(pairs.back().server, pairs.back().peer));
    }
    send(pairs[0], 1'500'000);
    send(pairs[1], 3'000'000);
    send(pairs[2], 1'500'000);
    table.sweep(Clock::now());
    EXPECT_TRUE(is_cut(pairs[1]));
    EXPECT_EQ(table.cut(), 1u);
}

}  // namespace
}  // namespace jostle::server
