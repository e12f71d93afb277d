// SPDX-License-Identifier: MIT
//
// The connections of the gRPC port: how many there are, in all and of each address, and what each
// has sent that no message came of yet. gRPC buffers an unfinished message however long it says it
// will be, and answers frames that carry nothing as fast as they come, so who sends much more than
// arrives as messages is cut.
//
// gRPC owns the sockets and does not say when it closes one. A socket's cookie is never used again,
// so a descriptor whose socket has another cookie, or none, is not ours any more.
//
// Thread rule: admit() and sweep() on the accepting thread; find() and the meters on any.
#pragma once

#include <sys/socket.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/clock.h"

namespace jostle::server {

// Kept by those who take messages off a connection.
struct ConnectionMeter {
    std::atomic<std::uint64_t> consumed{0};  // bytes of messages that arrived
    std::atomic<int> calls{0};               // that are open
};

struct ConnectionTableLimits {
    std::size_t total_max = 4000;
    std::size_t per_address_max = 512;             // of one IPv4 address or IPv6 /64
    double unread_bytes_max = 8.0 * 1024 * 1024;   // of one connection
    double unread_total_max = 64.0 * 1024 * 1024;  // of all; beyond it the largest is cut
};

class ConnectionTable {
public:
    enum class Refusal { full, address_full };

    explicit ConnectionTable(ConnectionTableLimits limits) : limits_(limits) {}

    // A connection that was accepted: counts it, or says why it is to be closed at once.
    std::optional<Refusal> admit(int descriptor, const sockaddr_storage& peer);
    // Forgets who is gone and cuts who sends what nobody reads. Often: each 20 ms.
    void sweep(Clock::time_point now);

    // By gRPC's name of a peer; null: gone, or not one of ours.
    std::shared_ptr<ConnectionMeter> find(const std::string& peer) const;
    std::size_t size() const;
    std::uint64_t cut() const { return cut_.load(std::memory_order_relaxed); }

private:
    struct Connection {
        int descriptor = -1;
        std::uint64_t cookie = 0;
        std::string peer, address;
        std::shared_ptr<ConnectionMeter> meter;
        std::uint64_t received = 0, consumed = 0;
        double unread = 0;  // bytes
        Clock::time_point looked;
        bool busy = true;  // sent a lot when it was last looked at
    };

    bool measure(Connection& connection, Clock::time_point now) const;
    void cut(Connection& connection, const char* why);
    void forget_gone();

    const ConnectionTableLimits limits_;
    mutable std::mutex mutex_;
    std::map<std::string, Connection> connections_;  // by peer
    std::map<std::string, std::size_t> of_address_;
    std::atomic<std::uint64_t> cut_{0};
};

}  // namespace jostle::server
