// SPDX-License-Identifier: MIT
//
// The gRPC port: connections are accepted, guarded and relayed by the server itself; play streams
// run on shards, all other calls in the dispatcher. Call start(), then drain() and stop() in this
// order, each from one thread.
#pragma once

#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "jostle/base/result.h"
#include "server/grpc/play_shard.h"
#include "server/grpc/unary_dispatcher.h"
#include "server/grpc_proxy/connection_acceptor.h"
#include "server/grpc_proxy/connection_relay.h"
#include "server/tls/certificate_store.h"

namespace jostle::server {

struct GrpcSettings {
    std::string host = "127.0.0.1";
    std::uint16_t port = 50051;  // 0: any free port
    int network_threads = 1;
    const CertificateStore* certificates = nullptr;  // null: no TLS; outlives the server
    const TrustedProxies* proxies = nullptr;         // null: none; outlive the server
    bool proxy_protocol = false;      // connections of trusted proxies begin with a PROXY header
    int message_bytes_max = 4 << 20;  // of a request; each method may have a smaller limit
    ConnectionTableLimits connections = {};
    RelayLimits relay = {};
    const ListenerMetrics* metrics = nullptr;  // null: no counting
    // of a peer that acknowledges nothing
    Clock::duration tcp_user_timeout = std::chrono::seconds(10);
    Clock::duration idle_max = std::chrono::minutes(5);  // of a connection without a call
};

class GrpcServer {
public:
    // `methods`: all methods except play streams, health and reflection. `is_healthy`: called on
    // any thread. The context outlives the server.
    GrpcServer(PlayContext& context, std::vector<CallMethod> methods,
               std::function<bool()> is_healthy, GrpcSettings settings);
    ~GrpcServer();

    // Binds and starts serving. An error names the address and the reason.
    Status start();
    std::uint16_t port() const { return acceptor_.port(); }  // the bound port, after start()

    // Any thread. Why gRPC does not serve, according to its last self-probe; empty: it serves.
    std::optional<std::string> failure_reason(Clock::time_point now) const;

    // Any thread: a world has a new frame, or the context has started to drain.
    void wake();
    // Health reports NOT_SERVING, new connections are refused, and open connections get GOAWAY.
    // Open streams continue for at most `timeout`.
    void drain(Clock::duration timeout);
    // Ends all remaining calls and threads.
    void stop();

private:
    void probe_self();
    std::vector<CallMethod> all_methods(std::vector<CallMethod> methods,
                                        std::function<bool()> is_healthy);

    PlayContext& context_;
    const GrpcSettings settings_;
    std::atomic<bool> serving_{false};
    RawPlayService play_service_;
    UnaryDispatcher dispatcher_;
    ConnectionTable table_;
    ConnectionRelay relay_;
    ConnectionAcceptor acceptor_;
    std::unique_ptr<grpc::experimental::ExternalConnectionAcceptor> external_acceptor_;
    std::vector<std::unique_ptr<PlayShard>> shards_;
    std::unique_ptr<grpc::Server> server_;
    std::thread shutdown_, prober_;
    std::atomic<Clock::rep> probed_at_{0};  // time of the last successful self-probe
    std::mutex prober_mutex_;
    std::condition_variable prober_wake_;
    bool stopped_ = false;
};

}  // namespace jostle::server
