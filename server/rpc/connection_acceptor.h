// SPDX-License-Identifier: MIT
//
// Accepts the connections of the gRPC port, in the place of gRPC, which knows no limit and goes
// deaf when descriptors run out. Has a thread of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <thread>

#include "jostle/base/result.h"
#include "rpc/connection_table.h"
#include "telemetry/metrics.h"

namespace jostle::server {

class ConnectionAcceptor {
public:
    // Takes the descriptor over.
    using HandOver = std::function<void(int descriptor)>;

    // `metrics` outlives the acceptor; null: nobody counts.
    explicit ConnectionAcceptor(ConnectionTableLimits limits,
                                const ListenerMetrics* metrics = nullptr)
        : table_(limits), metrics_(metrics) {}
    ~ConnectionAcceptor();

    // Binds. An error says which address and why. Port 0: any that is free.
    Status listen(const std::string& host, std::uint16_t port);
    std::uint16_t port() const { return port_; }  // the real one
    void start(HandOver hand_over);
    // No new connections from now on; those there are stay measured until stop().
    void close();
    void stop();

    ConnectionTable& table() { return table_; }
    // Any thread: false while it cannot take connections for want of descriptors or memory, and
    // when its thread has not looked for a second.
    bool is_listening(Clock::time_point now) const;

private:
    void run();
    void accept_all();
    void accept_one(int descriptor, const sockaddr_storage& peer);
    void tell_refusals(Clock::time_point now);

    ConnectionTable table_;
    const ListenerMetrics* const metrics_;
    HandOver hand_over_;
    int listener_ = -1;
    int wake_ = -1;  // an eventfd
    std::uint16_t port_ = 0;
    std::atomic<bool> closed_{false}, stopping_{false};
    std::atomic<Clock::rep> looked_{0}, starved_{0};  // when it did last, when it failed last
    std::uint64_t refused_ = 0, refused_told_ = 0;
    Clock::time_point told_{}, accept_again_{};
    std::thread thread_;
};

}  // namespace jostle::server
