// SPDX-License-Identifier: MIT
//
// Network emulator for TCP: forwards connections to a target in both directions with impairments.
// The data in transit is bounded: beyond the limit the proxy stops reading, and TCP flow control
// slows the sender down. One thread; for loopback and test networks only.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "jostle/base/network_queue.h"
#include "jostle/base/result.h"
#include "tools/common/socket_address.h"

namespace jostle::network_emulator {

using Clock = std::chrono::steady_clock;

struct TcpProxySettings {
    std::string target;  // HOST:PORT
    // Towards the clients. The other direction has no stalls and no bandwidth limit.
    NetworkConditions down;
};

class TcpProxy {
public:
    explicit TcpProxy(TcpProxySettings settings) : settings_(std::move(settings)) {}
    ~TcpProxy();
    TcpProxy(const TcpProxy&) = delete;
    TcpProxy& operator=(const TcpProxy&) = delete;

    // Listens on HOST:PORT; port 0 selects a free port.
    Status listen(const std::string& address);
    int port() const { return port_; }
    void run(const std::atomic<bool>& stop);

private:
    using Chunks = NetworkQueue<std::string>;
    struct Direction {
        int from, to;
        Chunks chunks;
        std::size_t written = 0;  // bytes of the first chunk
        bool ended = false;       // no more data will arrive
    };
    struct ProxiedConnection {
        std::array<Direction, 2> directions;  // down, up
        bool broken = false;
    };

    void accept_all();
    void read(Direction& direction, ProxiedConnection& connection, Clock::time_point now) const;
    static void write_due(Direction& direction, ProxiedConnection& connection,
                          Clock::time_point now);
    Clock::time_point serve(ProxiedConnection& connection, Clock::time_point now) const;

    TcpProxySettings settings_;
    common::SocketAddress target_;
    int listener_ = -1, port_ = 0;
    std::vector<std::unique_ptr<ProxiedConnection>> connections_;
    std::uint32_t accepted_ = 0;
};

}  // namespace jostle::network_emulator
