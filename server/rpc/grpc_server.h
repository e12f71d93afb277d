// SPDX-License-Identifier: MIT
//
// The gRPC port: play streams on shards of their own, WorldService, QueryService, AdminService,
// health and reflection. start(), then drain() and stop() in that order; each from one thread.
#pragma once

#include <grpcpp/server.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "rpc/admin_service.h"
#include "rpc/health_service.h"
#include "rpc/play_shard.h"
#include "rpc/query_service.h"
#include "rpc/world_service.h"

namespace jostle::server {

struct GrpcSettings {
    std::string host = "127.0.0.1";
    std::uint16_t port = 50051;  // 0: any that is free
    int network_threads = 1;
    int message_bytes_max =
        4 * 1024 * 1024;  // a scene in CreateWorld; play streams have a smaller limit of their own
    AdminControl* admin = nullptr;  // outlives the server; null: AdminService is not served
};

class GrpcServer {
public:
    // All three outlive the server.
    GrpcServer(PlayContext& context, WorldControl& worlds, const QueryControl& queries,
               GrpcSettings settings);
    ~GrpcServer();

    // Binds and begins to serve. An error says which address and why.
    Status start();
    std::uint16_t port() const { return port_; }  // the real one, after start()

    // Any thread: a world has a new frame, or the context began to drain.
    void wake();
    // Health answers NOT_SERVING from now on; streams that run go on.
    void drain();
    // Ends what is left and all threads.
    void stop();

private:
    PlayContext& context_;
    const GrpcSettings settings_;
    RawPlayService play_service_;
    WorldService world_service_;
    QueryService query_service_;
    std::optional<AdminService> admin_service_;
    HealthService health_service_;
    std::vector<std::unique_ptr<PlayShard>> shards_;
    std::unique_ptr<grpc::Server> server_;
    std::uint16_t port_ = 0;
    bool stopped_ = false;
};

}  // namespace jostle::server
