// SPDX-License-Identifier: MIT
//
// Network emulator for TCP: forwards connections to a target in both directions with impairments.
// The data in transit is bounded: beyond the limit the proxy stops reading, and TCP flow control
// slows the sender down. One thread; for loopback and test networks only.
#pragma once

#include <sys/socket.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "tools/network_emulator/path_emulator.h"

namespace jostle::network_emulator {

struct TcpProxySettings {
    std::string target;  // HOST:PORT
    NetworkConditions
        // towards the clients; the other direction has the same delay and jitter, no stalls and no
        // limit
        down;
    std::size_t queue_bytes = 65'536;  // in transit, per direction of a connection
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
    struct Chunk {
        std::string bytes;
        Clock::time_point at;
    };
    struct Direction {
        int from, to;
        PathEmulator path;
        std::deque<Chunk> chunks;
        std::size_t queued = 0;
        bool ended = false;  // no more data will arrive
    };
    struct ProxiedConnection {
        std::array<Direction, 2> directions;  // down, up
        bool broken = false;
    };

    void accept_all(Clock::time_point now);
    void read(Direction& direction, ProxiedConnection& connection, Clock::time_point now) const;
    static void write_due(Direction& direction, ProxiedConnection& connection,
                          Clock::time_point now);
    Clock::time_point serve(ProxiedConnection& connection, Clock::time_point now) const;

    TcpProxySettings settings_;
    sockaddr_storage target_{};
    socklen_t target_size_ = 0;
    int listener_ = -1, port_ = 0;
    std::vector<std::unique_ptr<ProxiedConnection>> connections_;
    std::uint64_t accepted_ = 0;
};

}  // namespace jostle::network_emulator
