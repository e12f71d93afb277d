// SPDX-License-Identifier: MIT
//
// Accepts the connections of the gRPC port, reads PROXY headers and performs TLS handshakes. It
// replaces the listener of gRPC, which has no connection limit and stops accepting when descriptors
// run out. Its thread has a lower priority than the threads that move bytes, so that connection
// floods do not slow connected clients.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "jostle/base/result.h"
#include "server/forwarding/proxy_protocol.h"
#include "server/grpc_proxy/client_socket.h"
#include "server/grpc_proxy/connection_table.h"
#include "server/metrics/metrics.h"
#include "server/tls/tls_contexts.h"

namespace jostle::server {

class ConnectionAcceptor {
public:
    // Called on the acceptor's thread for each admitted client.
    using Handler = std::function<void(std::unique_ptr<ClientSocket>, std::shared_ptr<Connection>)>;

    // All arguments must outlive the acceptor. Null certificates: no TLS; null metrics: no
    // counting. `tcp_user_timeout`: a peer that acknowledges nothing for this long is disconnected.
    // `proxy_protocol`: connections of trusted proxies begin with a PROXY header.
    ConnectionAcceptor(ConnectionTable& table, const CertificateStore* certificates,
                       Clock::duration tcp_user_timeout, const ListenerMetrics* metrics,
                       bool proxy_protocol = false)
        : table_(table),
          tls_(certificates, {.only_http2 = true}),
          tcp_user_timeout_(tcp_user_timeout),
          proxy_protocol_(proxy_protocol),
          metrics_(metrics) {}
    ~ConnectionAcceptor();

    // Binds. An error names the address and the reason. Port 0 selects a free port.
    Status listen(const std::string& host, std::uint16_t port);
    std::uint16_t port() const { return port_; }  // the bound port
    void start(Handler handler);
    // Stops accepting connections.
    void stop();

    // Any thread. False while no connection can be accepted for lack of descriptors or memory, or
    // if the thread has not polled for 1 s.
    bool is_listening(Clock::time_point now) const;

private:
    // A connection whose PROXY header or TLS handshake is not complete.
    struct PendingHandshake {
        std::unique_ptr<ClientSocket> socket;
        std::shared_ptr<Connection> connection;
        Clock::time_point deadline;
        std::optional<ProxyHeaderReader> proxy_header = {};  // until it is complete
        bool has_first_bytes = false;                        // of TLS
    };
    // State of a handshake after one of its steps.
    enum class Progress { waits, done, failed };

    void run();
    void set_epoll_events(int descriptor, std::uint32_t events, int how) const;
    void accept_all(Clock::time_point now);
    void accept_one(int descriptor, const sockaddr_storage& peer, Clock::time_point now);
    void count(ConnectionTable::Refusal why);
    void continue_handshake(int descriptor, Clock::time_point now);
    Progress read_proxy_header(PendingHandshake& pending, Clock::time_point now);
    Progress continue_tls(PendingHandshake& pending);
    void hand_off(std::unique_ptr<ClientSocket> socket,
                  const std::shared_ptr<Connection>& connection);
    void reject(PendingHandshake& pending, ConnectionRefusal refusal, const std::string& why);
    void drop_timed_out(Clock::time_point now);
    void log_refusals(Clock::time_point now);

    ConnectionTable& table_;
    TlsContexts tls_;
    const Clock::duration tcp_user_timeout_;
    const bool proxy_protocol_;
    const ListenerMetrics* const metrics_;
    Handler handler_;
    int listener_ = -1, epoll_ = -1;
    int wake_ = -1;  // an eventfd
    std::uint16_t port_ = 0;
    std::map<int, PendingHandshake> pending_handshakes_;  // by descriptor
    std::atomic<bool> stopping_{false};
    // time of the last poll and of the last failure
    std::atomic<Clock::rep> polled_at_{0}, failed_at_{0};
    std::uint64_t refused_ = 0, refused_logged_ = 0;
    Clock::time_point logged_at_{}, accept_again_{};
    std::thread thread_;
};

}  // namespace jostle::server
