// SPDX-License-Identifier: MIT
//
// Relays datagrams between one client and a server on the loopback device and drops a percentage of
// them. Runs in its own thread; the settings can be changed at any time.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <random>
#include <thread>

namespace jostle::test {

class UdpProxy {
public:
    UdpProxy() : clients_(bound()), servers_(bound()), port_(port_of(clients_)) {}
    ~UdpProxy() {
        stop_ = true;
        if (thread_.joinable()) thread_.join();
        close(clients_);
        close(servers_);
    }
    UdpProxy(const UdpProxy&) = delete;
    UdpProxy& operator=(const UdpProxy&) = delete;

    std::uint16_t port() const { return port_; }
    void start(std::uint16_t server) {
        server_ = server;
        thread_ = std::thread([this] { run(); });
    }

    std::atomic<int> up_loss_percent{0}, down_loss_percent{0};
    std::atomic<int> up{0}, down{0};  // received packets, including dropped ones

private:
    static int bound() {
        const int descriptor = socket(AF_INET, SOCK_DGRAM, 0);
        sockaddr_in address = loopback(0);
        EXPECT_EQ(bind(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        return descriptor;
    }
    static sockaddr_in loopback(std::uint16_t port) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return address;
    }
    static std::uint16_t port_of(int descriptor) {
        sockaddr_in address{};
        socklen_t size = sizeof address;
        getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size);
        return ntohs(address.sin_port);
    }
    bool loses(int percent) { return static_cast<int>(random_() % 100) < percent; }

    void run() {
        sockaddr_in client = loopback(0), server = loopback(server_);
        std::array<pollfd, 2> sockets{pollfd{.fd = clients_, .events = POLLIN, .revents = 0},
                                      pollfd{.fd = servers_, .events = POLLIN, .revents = 0}};
        std::array<char, 2000> packet;
        while (!stop_) {
            if (poll(sockets.data(), sockets.size(), 20) <= 0) continue;
            if (sockets[0].revents != 0) {
                socklen_t size = sizeof client;
                const ssize_t bytes = recvfrom(clients_, packet.data(), packet.size(), 0,
                                               reinterpret_cast<sockaddr*>(&client), &size);
                up++;
                if (bytes > 0 && !loses(up_loss_percent))
                    sendto(servers_, packet.data(), static_cast<std::size_t>(bytes), 0,
                           reinterpret_cast<sockaddr*>(&server), sizeof server);
            }
            if (sockets[1].revents != 0) {
                const ssize_t bytes = recv(servers_, packet.data(), packet.size(), 0);
                down++;
                if (bytes > 0 && !loses(down_loss_percent))
                    sendto(clients_, packet.data(), static_cast<std::size_t>(bytes), 0,
                           reinterpret_cast<sockaddr*>(&client), sizeof client);
            }
        }
    }

    const int clients_, servers_;
    const std::uint16_t port_;
    std::uint16_t server_ = 0;
    std::mt19937 random_{7};
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

}  // namespace jostle::test
