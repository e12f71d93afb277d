// SPDX-License-Identifier: MIT
//
// The connections of the gRPC port: how many there are, in all and of each address, and which
// addresses were caught at an attack and have to wait. Any thread.
#pragma once

#include <sys/socket.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/util/clock.h"

namespace jostle::server {

// What the side that moves bytes and the side that answers calls tell each other.
struct Connection {
    std::string name;         // unique; gRPC's name of the peer is grpc_name()
    std::string peer;         // "192.0.2.7:4711"
    std::string address;      // "192.0.2.7"
    std::string network;      // network_of(address)
    std::string certificate;  // subject that TLS has verified; empty: none was shown

    // Written by who answers.
    std::atomic<std::uint64_t> consumed{0};        // bytes of messages that arrived
    std::atomic<std::uint64_t> calls_accepted{0};  // that gRPC gave us
    std::atomic<int> calls{0};                     // that are open
    std::atomic<int> unary_calls{0};               // ... and are no play streams

    std::string grpc_name() const { return "unix-abstract:" + name; }
};

struct ConnectionTableLimits {
    std::size_t total_max = 4000;
    std::size_t per_address_max = 512;  // of one IPv4 address or IPv6 /64
};

class ConnectionTable {
public:
    enum class Refusal { full, address_full, address_penalized };

    explicit ConnectionTable(ConnectionTableLimits limits) : limits_(limits) {}

    // Somebody has connected: why he is to be turned away; nothing: he is not.
    std::optional<Refusal> refusal_for(const sockaddr_storage& peer, Clock::time_point now) const;
    // Counts it until forget().
    std::shared_ptr<Connection> admit(const sockaddr_storage& peer);
    void remove(const Connection& connection);

    // It did what no client does: its address gets no new connection for a second, and each time
    // that happens again for twice as long, up to a minute.
    void penalize(const Connection& connection, Clock::time_point now);

    // By gRPC's name of a peer. One that is gone, or that the process has with itself, is a
    // connection from nowhere.
    std::shared_ptr<Connection> of(std::string_view grpc_name) const;
    std::size_t size() const;

private:
    struct Penalty {
        Clock::time_point until;
        int count = 0;
    };

    void forget_penalties(Clock::time_point now);

    const ConnectionTableLimits limits_;
    mutable std::mutex mutex_;
    std::uint64_t last_number_ = 0;
    std::map<std::string, std::shared_ptr<Connection>, std::less<>> connections_;  // by gRPC's name
    std::map<std::string, std::size_t> of_network_;
    std::map<std::string, Penalty> penalties_;  // by network
};

}  // namespace jostle::server
