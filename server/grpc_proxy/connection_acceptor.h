// SPDX-License-Identifier: MIT
//
// Accepts the connections of the gRPC port, in the place of gRPC, which knows no limit and goes
// deaf when descriptors run out, and agrees with them on TLS. Has a thread of its own, which stands
// back behind those that move bytes: who only connects, however often, slows nobody who plays.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include "jostle/base/result.h"
#include "server/grpc_proxy/client_socket.h"
#include "server/grpc_proxy/connection_table.h"
#include "server/metrics/metrics.h"
#include "server/tls/tls_contexts.h"

namespace jostle::server {

class ConnectionAcceptor {
public:
    // A client that is let in. Called on the acceptor's thread.
    using Handler = std::function<void(std::unique_ptr<ClientSocket>, std::shared_ptr<Connection>)>;

    // All outlive the acceptor. Null certificates: without TLS; null metrics: nobody counts.
    // `tcp_user_timeout`: a peer that takes nothing for so long is gone.
    ConnectionAcceptor(ConnectionTable& table, const CertificateStore* certificates,
                       Clock::duration tcp_user_timeout, const ListenerMetrics* metrics)
        : table_(table),
          tls_(certificates, {.only_http2 = true}),
          tcp_user_timeout_(tcp_user_timeout),
          metrics_(metrics) {}
    ~ConnectionAcceptor();

    // Binds. An error says which address and why. Port 0: any that is free.
    Status listen(const std::string& host, std::uint16_t port);
    std::uint16_t port() const { return port_; }  // the real one
    void start(Handler handler);
    // No new connections from now on.
    void stop();

    // Any thread: false while it cannot take connections for want of descriptors or memory, and
    // when its thread has not looked for a second.
    bool is_listening(Clock::time_point now) const;

private:
    // One that TLS is not agreed with yet.
    struct PendingHandshake {
        std::unique_ptr<ClientSocket> socket;
        std::shared_ptr<Connection> connection;
        Clock::time_point deadline;
    };

    void run();
    void set_epoll_events(int descriptor, std::uint32_t events, int how) const;
    void accept_all(Clock::time_point now);
    void accept_one(int descriptor, const sockaddr_storage& peer, Clock::time_point now);
    void count(ConnectionTable::Refusal why);
    void continue_handshake(int descriptor);
    void hand_off(std::unique_ptr<ClientSocket> socket,
                  const std::shared_ptr<Connection>& connection);
    void reject(PendingHandshake& pending, const std::string& why);
    void drop_timed_out(Clock::time_point now);
    void log_refusals(Clock::time_point now);

    ConnectionTable& table_;
    TlsContexts tls_;
    const Clock::duration tcp_user_timeout_;
    const ListenerMetrics* const metrics_;
    Handler handler_;
    int listener_ = -1, epoll_ = -1;
    int wake_ = -1;  // an eventfd
    std::uint16_t port_ = 0;
    std::map<int, PendingHandshake> pending_handshakes_;  // by descriptor
    std::atomic<bool> stopping_{false};
    std::atomic<Clock::rep> polled_at_{0}, failed_at_{0};  // when it did last, when it failed last
    std::uint64_t refused_ = 0, refused_logged_ = 0;
    Clock::time_point logged_at_{}, accept_again_{};
    std::thread thread_;
};

}  // namespace jostle::server
