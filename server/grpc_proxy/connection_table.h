// SPDX-License-Identifier: MIT
//
// The connections of the gRPC port: their number in total and per address, and the addresses that
// are blocked after an attack. Any thread.
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

#include "server/forwarding/trusted_proxies.h"
#include "server/util/clock.h"

namespace jostle::server {

// State shared between the relay and the calls of one connection.
struct Connection {
    std::string name;         // unique; gRPC's name of the peer is grpc_name()
    std::string peer;         // "192.0.2.7:4711"
    std::string address;      // "192.0.2.7"
    std::string network;      // network_of(address)
    std::string certificate;  // subject verified by TLS; empty: none
    // The address is that of a trusted proxy: the calls belong to several clients, which only their
    // headers name.
    bool is_proxy = false;

    // Written by the thread that handles calls.
    std::atomic<std::uint64_t> consumed{0};        // bytes of received messages
    std::atomic<std::uint64_t> calls_accepted{0};  // calls that gRPC reported
    std::atomic<int> calls{0};                     // open calls
    std::atomic<int> unary_calls{0};               // open calls except play streams

    std::string grpc_name() const { return "unix-abstract:" + name; }
};

struct ConnectionTableLimits {
    std::size_t total_max = 4000;
    std::size_t per_address_max = 512;  // per IPv4 address or IPv6 /64
};

class ConnectionTable {
public:
    enum class Refusal { full, address_full, address_penalized };

    // `proxies` outlive the table; null: none. Their connections are not limited per address and
    // not penalized.
    explicit ConnectionTable(ConnectionTableLimits limits, const TrustedProxies* proxies = nullptr)
        : limits_(limits), proxies_(proxies) {}

    bool is_proxy(const sockaddr_storage& peer) const;

    // The reason to refuse a new connection; empty: accept it.
    std::optional<Refusal> refusal_for(const sockaddr_storage& peer, Clock::time_point now) const;
    // Counts the connection until remove().
    std::shared_ptr<Connection> admit(const sockaddr_storage& peer);
    void remove(const Connection& connection);
    // Replaces the address of a connection that was not handed off yet: its proxy named the client.
    // Returns the reason to refuse the client; then nothing changes.
    std::optional<Refusal> set_client(Connection& connection, const sockaddr_storage& client,
                                      Clock::time_point now);

    // The address of the client of a call. `forwarded`: the value of the header named by
    // forwarded_header(), which counts only in connections of trusted proxies.
    std::string client_address(const Connection& connection, std::string_view forwarded) const;
    std::string_view forwarded_header() const;

    // Penalizes an attack: the address gets no new connection for 1 s; each repetition doubles the
    // time, up to 60 s.
    void penalize(const Connection& connection, Clock::time_point now);

    // Finds a connection by gRPC's peer name. A closed connection, or one that the process has with
    // itself, returns a placeholder without an address.
    std::shared_ptr<Connection> of(std::string_view grpc_name) const;
    std::size_t size() const;

private:
    struct Penalty {
        Clock::time_point until;
        int count = 0;
    };

    void forget_penalties(Clock::time_point now);
    std::optional<Refusal> address_refusal(const sockaddr_storage& peer,
                                           Clock::time_point now) const;
    void set_address(Connection& connection, const sockaddr_storage& peer);
    void count_address(const Connection& connection, int change);

    const ConnectionTableLimits limits_;
    const TrustedProxies* const proxies_;
    mutable std::mutex mutex_;
    std::uint64_t last_number_ = 0;
    // by gRPC's peer name
    std::map<std::string, std::shared_ptr<Connection>, std::less<>> connections_;
    std::map<std::string, std::size_t> of_network_;
    std::map<std::string, Penalty> penalties_;  // by network
};

}  // namespace jostle::server
