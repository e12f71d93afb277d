// SPDX-License-Identifier: MIT
//
// The gRPC port: connections that we accept, watch and relay ourselves, play streams on shards of
// their own, all other calls behind the call front. start(), then drain() and stop() in that order;
// each from one thread.
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
    std::uint16_t port = 50051;  // 0: any that is free
    int network_threads = 1;
    const CertificateStore* certificates = nullptr;  // null: without TLS; outlives the server
    ConnectionTableLimits connections = {};
    RelayLimits relay = {};
    const ListenerMetrics* metrics = nullptr;                     // null: nobody counts
    Clock::duration tcp_user_timeout = std::chrono::seconds(10);  // of who takes nothing
    Clock::duration idle_max = std::chrono::minutes(5);           // of a connection without a call
};

class GrpcServer {
public:
    // `methods`: all that is not a play stream, but for health and reflection. `is_healthy`: any
    // thread. The context outlives the server.
    GrpcServer(PlayContext& context, std::vector<CallMethod> methods,
               std::function<bool()> is_healthy, GrpcSettings settings);
    ~GrpcServer();

    // Binds and begins to serve. An error says which address and why.
    Status start();
    std::uint16_t port() const { return acceptor_.port(); }  // the real one, after start()

    // Any thread: why gRPC does not serve, as it found when it asked itself last; nothing: it does.
    std::optional<std::string> failure_reason(Clock::time_point now) const;

    // Any thread: a world has a new frame, or the context began to drain.
    void wake();
    // Health answers NOT_SERVING and nobody new is let in; each connection is told to go elsewhere
    // (GOAWAY). Streams that run go on for so long.
    void drain(Clock::duration timeout);
    // Ends what is left and all threads.
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
    std::atomic<Clock::rep> probed_at_{0};  // when it last answered itself
    std::mutex prober_mutex_;
    std::condition_variable prober_wake_;
    bool stopped_ = false;
};

}  // namespace jostle::server
