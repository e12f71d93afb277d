// SPDX-License-Identifier: MIT
#include "tools/network_emulator/tcp_proxy.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

namespace jostle::network_emulator {
namespace {

sockaddr_in loopback(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
}

// Echoes the data of one client until the client closes its direction.
class Echo {
public:
    Echo() : listener_(socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address = loopback(0);
        socklen_t size = sizeof address;
        bind(listener_, reinterpret_cast<sockaddr*>(&address), size);
        listen(listener_, 1);
        getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
        port = ntohs(address.sin_port);
        thread_ = std::thread([this] { run(); });
    }
    ~Echo() {
        thread_.join();
        close(listener_);
    }

    int port = 0;

private:
    void run() const {
        const int client = accept(listener_, nullptr, nullptr);
        char scratch[4096];
        for (ssize_t n = 0; (n = recv(client, scratch, sizeof scratch, 0)) > 0;)
            send(client, scratch, static_cast<std::size_t>(n), MSG_NOSIGNAL);
        close(client);
    }

    int listener_;
    std::thread thread_;
};

}  // namespace

TEST(TcpProxy, forwards_bytes_unchanged_with_the_configured_delay_each_way) {
    const Echo echo;
    TcpProxy relay({.target = "127.0.0.1:" + std::to_string(echo.port),
                    .down = {.latency_ms = 30, .jitter_ms = 5}});
    ASSERT_TRUE(relay.listen("127.0.0.1:0"));
    std::atomic<bool> stop{false};
    std::thread thread([&] { relay.run(stop); });

    const int client = socket(AF_INET, SOCK_STREAM, 0);
    const sockaddr_in address = loopback(relay.port());
    ASSERT_EQ(connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    std::string said;
    for (int k = 0; k < 20'000; k++) said += std::to_string(k) + ' ';
    const auto began = Clock::now();
    ASSERT_EQ(send(client, said.data(), said.size(), 0), static_cast<ssize_t>(said.size()));
    shutdown(client, SHUT_WR);
    std::string heard;
    char scratch[4096];
    for (ssize_t n = 0; (n = recv(client, scratch, sizeof scratch, 0)) > 0;) {
        if (heard.empty()) {
            EXPECT_GE(Clock::now() - began, std::chrono::milliseconds(60));
        }
        heard.append(scratch, static_cast<std::size_t>(n));
    }
    EXPECT_EQ(heard, said);
    close(client);
    stop = true;
    thread.join();
}

TEST(TcpProxy, rejects_an_invalid_address) {
    TcpProxy nowhere({.target = "here", .down = {}});
    EXPECT_EQ(nowhere.listen("127.0.0.1:0").error().message,
              "\"here\" is not of the form HOST:PORT");
}

}  // namespace jostle::network_emulator
