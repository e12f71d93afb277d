// SPDX-License-Identifier: MIT
#include "rpc/grpc_server.h"

#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/server_builder.h>
#include <spdlog/fmt/fmt.h>

#include <chrono>

#include "rpc/rpc_counter.h"

namespace jostle::server {

namespace {

constexpr auto shutdown_patience = std::chrono::seconds(1);

// A peer that vanished without a word is noticed within half a minute; clients may ping every 10 s
// or slower.
void set_keepalive(grpc::ServerBuilder& builder) {
    builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, 20'000);
    builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 10'000);
    builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
    builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 10'000);
}

std::string address_of(const std::string& host, std::uint16_t port) {
    const bool is_ipv6 = host.find(':') != std::string::npos;
    return is_ipv6 ? fmt::format("[{}]:{}", host, port) : fmt::format("{}:{}", host, port);
}

}  // namespace

GrpcServer::GrpcServer(PlayContext& context, WorldControl& worlds, const QueryControl& queries,
                       GrpcSettings settings)
    : context_(context),
      settings_(std::move(settings)),
      world_service_(worlds),
      query_service_(queries),
      health_service_(
          {"jostle.v1.PlayService", "jostle.v1.QueryService", "jostle.v1.WorldService"}) {
    if (settings_.admin) admin_service_.emplace(*settings_.admin);
}

GrpcServer::~GrpcServer() {
    stop();
}

Status GrpcServer::start() {
    grpc::reflection::InitProtoReflectionServerBuilderPlugin();
    grpc::ServerBuilder builder;
    const std::string address = address_of(settings_.host, settings_.port);
    int bound = 0;
    builder.AddListeningPort(address, grpc::InsecureServerCredentials(), &bound);
    // Two servers on one port would each get some of the clients; the second should fail instead.
    builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
    builder.SetMaxReceiveMessageSize(settings_.message_bytes_max);
    set_keepalive(builder);
    if (context_.rpc_metrics)
        builder.experimental().SetInterceptorCreators(rpc_counters(*context_.rpc_metrics));
    builder.RegisterService(&play_service_);
    builder.RegisterService(&world_service_);
    builder.RegisterService(&query_service_);
    if (admin_service_) builder.RegisterService(&*admin_service_);
    builder.RegisterService(&health_service_);
    for (int i = 0; i < settings_.network_threads; ++i) {
        shards_.push_back(
            std::make_unique<PlayShard>(context_, play_service_, builder.AddCompletionQueue()));
    }
    server_ = builder.BuildAndStart();
    if (!server_ || bound == 0) {
        return Error{
            ErrorCode::unavailable,
            fmt::format(
                "cannot listen on {} for gRPC: the port is taken or the address is not of this "
                "machine; choose another with --listen HOST:PORT",
                address)};
    }
    port_ = static_cast<std::uint16_t>(bound);
    health_service_.set_serving(true);
    for (const auto& shard : shards_) shard->start();
    return {};
}

void GrpcServer::wake() {
    for (const auto& shard : shards_) shard->wake();
}

void GrpcServer::drain() {
    health_service_.set_serving(false);
}

void GrpcServer::stop() {
    if (stopped_) return;
    stopped_ = true;
    // The shards still run: they take the ends of their streams off their queues.
    if (server_) server_->Shutdown(std::chrono::system_clock::now() + shutdown_patience);
    for (const auto& shard : shards_) shard->stop();
}

}  // namespace jostle::server
