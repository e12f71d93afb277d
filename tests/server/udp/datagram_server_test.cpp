// SPDX-License-Identifier: MIT
//
// Tests with real sockets on the loopback device and a client that uses a PacketCipher.
#include "server/udp/datagram_server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <thread>

#include "tests/support/wait_until.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using datagram::PacketCipher;
using datagram::Side;
using test::wait_until;

// A UDP socket that is connected to the port.
class End {
public:
    explicit End(std::uint16_t port) : descriptor_(socket(AF_INET, SOCK_DGRAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(connect(descriptor_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    }
    ~End() { close(descriptor_); }
    End(const End&) = delete;
    End& operator=(const End&) = delete;

    void send(const std::string& packet) const {
        ASSERT_EQ(::send(descriptor_, packet.data(), packet.size(), 0),
                  static_cast<ssize_t>(packet.size()));
    }
    // Returns nothing if no packet arrives in time.
    std::optional<std::string> receive(std::chrono::milliseconds timeout = 1000ms) const {
        pollfd polled{.fd = descriptor_, .events = POLLIN, .revents = 0};
        if (poll(&polled, 1, static_cast<int>(timeout.count())) != 1) return std::nullopt;
        std::string packet(2000, ' ');
        const ssize_t size = recv(descriptor_, packet.data(), packet.size(), 0);
        packet.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
        return packet;
    }

private:
    int descriptor_;
};

std::string message(std::string_view text) {
    return datagram::encode_message(std::span(&text, 1), 1)[0];
}

struct DatagramServerTest : testing::Test {
    void SetUp() override {
        ASSERT_TRUE(port.start().ok());
        path = *port.open([this](std::string_view) { messages++; });
        client = *PacketCipher::make(path->credentials(), Side::client);
        end = std::make_unique<End>(port.port());
    }
    void TearDown() override { port.stop(); }

    // Sends a packet, receives the path challenge and answers it.
    void validate_path(const End& from) {
        from.send(client->encrypt(message("")));
        const auto packet = from.receive();
        ASSERT_TRUE(packet);
        const auto question = client->decrypt(*packet);
        ASSERT_TRUE(question);
        const auto content = *datagram::decode_content(question->content);
        from.send(client->encrypt(datagram::encode(
            datagram::PathResponse{std::get<datagram::PathChallenge>(content).token})));
    }
    void send_message(std::string_view text) { path->send(std::span(&text, 1), Clock::now()); }

    DatagramServer port{{.host = "127.0.0.1", .port = 0}};
    std::shared_ptr<DatagramConnection> path;
    std::unique_ptr<PacketCipher> client;
    std::unique_ptr<End> end;
    std::atomic<int> messages{0};
};

}  // namespace

TEST_F(DatagramServerTest, sends_nothing_before_path_validation) {
    send_message("lost");
    EXPECT_FALSE(path->is_open(Clock::now()));
    end->send(client->encrypt(message("hello")));
    const auto first = end->receive();
    ASSERT_TRUE(first);
    EXPECT_EQ(first->size(), 41u) << "the challenge must not be larger than the received packet";
    EXPECT_FALSE(path->is_open(Clock::now()));
    send_message("lost, too");
    EXPECT_FALSE(end->receive(100ms));
    validate_path(*end);
    ASSERT_TRUE(wait_until([&] { return path->is_open(Clock::now()); }));
    send_message("now");
    const auto packet = end->receive();
    ASSERT_TRUE(packet);
    EXPECT_EQ(client->decrypt(*packet)->content, message("now"));
}

TEST_F(DatagramServerTest, delivers_each_client_message_once_with_its_receive_time) {
    const std::string packet = client->encrypt(message("push"));
    end->send(packet);
    end->send(packet);
    ASSERT_TRUE(wait_until([&] { return messages == 1; }));
    end->send(client->encrypt(message("pull")));
    ASSERT_TRUE(wait_until([&] { return messages == 2; }));
    EXPECT_TRUE(path->has_messages());
    const auto mail = path->take_messages();
    ASSERT_EQ(mail.size(), 2u);
    EXPECT_EQ(mail[0].message, "push");
    EXPECT_EQ(mail[1].message, "pull");
    EXPECT_GE(mail[1].at, mail[0].at);
    EXPECT_FALSE(path->has_messages());
}

TEST_F(DatagramServerTest, ignores_packets_without_the_key) {
    datagram::Credentials guessed = path->credentials();
    guessed.key[0] ^= 1;
    end->send((*PacketCipher::make(guessed, Side::client))->encrypt(message("let me in")));
    end->send(std::string(1200, 'x'));
    end->send("x");
    end->send(std::string(1400, 'x'));
    EXPECT_FALSE(end->receive(100ms));
    validate_path(*end);
    EXPECT_TRUE(wait_until([&] { return path->is_open(Clock::now()); }));
    EXPECT_EQ(path->take_messages().size(), 1u) << "only the message of validate_path()";
}

TEST_F(DatagramServerTest, validates_a_new_address_before_migrating) {
    validate_path(*end);
    ASSERT_TRUE(wait_until([&] { return path->is_open(Clock::now()); }));
    const End elsewhere(port.port());
    elsewhere.send(client->encrypt(message("I am here now")));
    ASSERT_TRUE(elsewhere.receive()) << "the server must send a challenge";
    send_message("to the old address");
    EXPECT_TRUE(end->receive());
    EXPECT_FALSE(elsewhere.receive(50ms));
    validate_path(elsewhere);
    EXPECT_TRUE(wait_until([&] {
        send_message("where are you?");
        return elsewhere.receive(20ms).has_value();
    }));
}

TEST_F(DatagramServerTest, replayed_packet_from_another_address_does_not_migrate) {
    validate_path(*end);
    ASSERT_TRUE(wait_until([&] { return path->is_open(Clock::now()); }));
    const std::string held_back = client->encrypt(message("old"));
    end->send(client->encrypt(message("new")));
    ASSERT_TRUE(wait_until([&] { return messages == 2; }));
    const End elsewhere(port.port());
    elsewhere.send(held_back);
    ASSERT_TRUE(wait_until([&] { return messages == 3; }));
    EXPECT_FALSE(elsewhere.receive(100ms)) << "a packet older than the newest one must be ignored";
}

TEST_F(DatagramServerTest, stops_sending_after_two_seconds_of_silence) {
    validate_path(*end);
    ASSERT_TRUE(wait_until([&] { return path->is_open(Clock::now()); }));
    EXPECT_TRUE(path->is_open(Clock::now() + 1900ms));
    EXPECT_FALSE(path->is_open(Clock::now() + 2100ms));
}

TEST_F(DatagramServerTest, rechallenges_idle_clients) {
    validate_path(*end);
    ASSERT_TRUE(wait_until([&] { return path->is_open(Clock::now()); }));
    std::this_thread::sleep_for(300ms);
    end->send(client->encrypt(message("still there?")));
    EXPECT_TRUE(end->receive()) << "the server must respond";
}

TEST_F(DatagramServerTest, bounds_unread_messages) {
    for (std::size_t i = 0; i < DatagramConnection::received_max + 50; i++) {
        end->send(client->encrypt(message("x")));
        if (i % 16 == 0) std::this_thread::sleep_for(1ms);
    }
    EXPECT_TRUE(
        wait_until([&] { return messages == static_cast<int>(DatagramConnection::received_max); }));
    std::this_thread::sleep_for(50ms);
    EXPECT_EQ(path->take_messages().size(), DatagramConnection::received_max);
}

TEST_F(DatagramServerTest, removes_closed_connections) {
    EXPECT_EQ(port.connections(), 1u);
    port.close(*path);
    EXPECT_EQ(port.connections(), 0u);
    end->send(client->encrypt(message("hello")));
    EXPECT_FALSE(end->receive(100ms));
    EXPECT_EQ(messages, 0);
}

TEST(DatagramServer, error_names_the_address) {
    DatagramServer first{{.host = "127.0.0.1", .port = 0}};
    ASSERT_TRUE(first.start().ok());
    DatagramServer second{{.host = "127.0.0.1", .port = first.port()}};
    const Status taken = second.start();
    ASSERT_FALSE(taken.ok());
    EXPECT_NE(taken.error().message.find("127.0.0.1:" + std::to_string(first.port())),
              std::string::npos);
    EXPECT_NE(taken.error().message.find("--datagrams"), std::string::npos);
    first.stop();
}

}  // namespace jostle::server
