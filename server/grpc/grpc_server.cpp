// SPDX-License-Identifier: MIT
#include "server/grpc/grpc_server.h"

#include <grpc/compression.h>
#include <grpc/grpc.h>
#include <grpcpp/resource_quota.h>

#include <algorithm>
#include <set>
#include <utility>

#include "grpc/health/v1/health.grpc.pb.h"
#include "jostle/base/check.h"
#include "server/grpc/library_setup.h"
#include "server/grpc/server_methods.h"

namespace jostle::server {

namespace {

// Limit of gRPC's own buffers; beyond it gRPC resets arbitrary streams. The relay stops reading
// long before.
constexpr std::size_t buffers_max = 512u << 20;
// Methods and play streams have lower limits of their own.
constexpr int streams_per_connection_max = 100;
constexpr int header_bytes_max = 8 * 1024;
constexpr int handshake_ms = 5'000;  // from the connection to the first SETTINGS
constexpr auto shutdown_timeout = std::chrono::seconds(1);
constexpr auto shutdown_flush_max = std::chrono::milliseconds(300);
constexpr auto probe_period = std::chrono::milliseconds(1000);
constexpr auto probe_timeout_max = std::chrono::milliseconds(2500);

// A peer that vanished silently is detected within 30 s; clients may ping at most every 10 s.
void set_keepalive(grpc::ServerBuilder& builder) {
    builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, 20'000);
    builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 10'000);
    builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
    builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 10'000);
}

void set_limits(grpc::ServerBuilder& builder, const GrpcSettings& settings) {
    builder.SetResourceQuota(grpc::ResourceQuota("jostle").Resize(buffers_max));
    builder.SetMaxReceiveMessageSize(settings.message_bytes_max);
    // A compressed request of a few bytes could expand to gigabytes, and small messages need no
    // compression.
    builder.AddChannelArgument(GRPC_COMPRESSION_CHANNEL_ENABLED_ALGORITHMS_BITSET,
                               1u << GRPC_COMPRESS_NONE);
    builder.AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS, streams_per_connection_max);
    builder.AddChannelArgument(GRPC_ARG_MAX_METADATA_SIZE, header_bytes_max);
    builder.AddChannelArgument(GRPC_ARG_SERVER_HANDSHAKE_TIMEOUT_MS, handshake_ms);
    builder.AddChannelArgument(
        GRPC_ARG_MAX_CONNECTION_IDLE_MS,
        static_cast<int>(
            std::chrono::duration_cast<std::chrono::milliseconds>(settings.idle_max).count()));
    // Limits the data that a client may send ahead of its reader; a window that grows with the
    // bandwidth would let clients fill the server's buffers.
    builder.AddChannelArgument(GRPC_ARG_HTTP2_BDP_PROBE, 0);
}

// Registers the methods whose calls are counted by name.
void register_methods(const std::vector<CallMethod>& methods, RpcMetrics& metrics) {
    using enum RpcMetrics::Kind;
    metrics.add(play_path, streaming);
    for (const CallMethod& method : methods) {
        metrics.add(method.path, method.stays_open() ? streaming : unary);
    }
}

}  // namespace

GrpcServer::GrpcServer(PlayContext& context, std::vector<CallMethod> methods,
                       std::function<bool()> is_healthy, GrpcSettings settings)
    : context_(context),
      settings_(std::move(settings)),
      dispatcher_(all_methods(std::move(methods), std::move(is_healthy)), context.authorizer, {},
                  context.rpc_metrics),
      table_(settings_.connections, settings_.proxies),
      relay_(table_, settings_.relay, settings_.metrics),
      acceptor_(table_, settings_.certificates, settings_.tcp_user_timeout, settings_.metrics,
                settings_.proxy_protocol) {}

GrpcServer::~GrpcServer() {
    stop();
}

std::vector<CallMethod> GrpcServer::all_methods(std::vector<CallMethod> methods,
                                                std::function<bool()> is_healthy) {
    std::set<std::string> services{"jostle.v1.PlayService"};
    for (const CallMethod& method : methods)
        services.insert(method.path.substr(1, method.path.rfind('/') - 1));
    std::vector<std::string> names(services.begin(), services.end());
    const auto add = [&](std::vector<CallMethod> more) {
        std::ranges::move(more, std::back_inserter(methods));
    };
    add(health_methods(
        names, [this, is_healthy = std::move(is_healthy)] { return serving_ && is_healthy(); }));
    names.insert(names.end(), {"grpc.health.v1.Health", "grpc.reflection.v1.ServerReflection",
                               "grpc.reflection.v1alpha.ServerReflection"});
    add(reflection_methods(std::move(names)));
    if (context_.rpc_metrics) register_methods(methods, *context_.rpc_metrics);
    return methods;
}

Status GrpcServer::start() {
    configure_libraries();
    if (Status s = acceptor_.listen(settings_.host, settings_.port); !s.ok()) return s;
    grpc::ServerBuilder builder;
    external_acceptor_ = builder.experimental().AddExternalConnectionAcceptor(
        grpc::ServerBuilder::experimental_type::ExternalConnectionType::FROM_FD,
        grpc::InsecureServerCredentials());  // TLS terminates at the relay
    set_keepalive(builder);
    set_limits(builder, settings_);
    builder.RegisterService(&play_service_);
    builder.RegisterAsyncGenericService(&dispatcher_.service());
    for (int i = 0; i < settings_.network_threads; ++i)
        shards_.push_back(std::make_unique<PlayShard>(context_, play_service_, table_,
                                                      builder.AddCompletionQueue()));
    server_ = builder.BuildAndStart();
    if (!server_) return Error{ErrorCode::unavailable, "cannot start the gRPC server"};
    ASSERT(!shards_.empty());
    dispatcher_.start(shards_.front()->queue(), table_);
    for (const auto& shard : shards_)
        shard->start(shard == shards_.front() ? &dispatcher_ : nullptr);
    serving_ = true;
    probed_at_ = Clock::now().time_since_epoch().count();
    ASSERT(!prober_.joinable());
    prober_ = std::thread([this] { probe_self(); });
    const Status relay_started = relay_.start([this](int descriptor) {
        grpc::experimental::ExternalConnectionAcceptor::NewConnectionParameters connection;
        connection.fd = descriptor;
        external_acceptor_->HandleNewConnection(&connection);
    });
    if (!relay_started.ok()) return relay_started.error();
    acceptor_.start(
        [this](std::unique_ptr<ClientSocket> client, std::shared_ptr<Connection> connection) {
            relay_.add(std::move(client), std::move(connection));
        });
    return {};
}

std::optional<std::string> GrpcServer::failure_reason(Clock::time_point now) const {
    if (now - Clock::time_point(Clock::duration(probed_at_)) > probe_timeout_max)
        return "gRPC does not respond";
    if (!relay_.is_responsive(now)) return "the gRPC connection relay is stalled";
    if (!acceptor_.is_listening(now)) return "gRPC accepts no connections";
    return std::nullopt;
}

// Probes gRPC and the dispatcher over an in-process channel, which needs no descriptor: the number
// of connections does not affect health.
void GrpcServer::probe_self() {
    const auto health = grpc::health::v1::Health::NewStub(server_->InProcessChannel({}));
    std::unique_lock lock(prober_mutex_);
    do {
        lock.unlock();
        grpc::ClientContext call;
        call.set_deadline(std::chrono::system_clock::now() + probe_period);
        grpc::health::v1::HealthCheckResponse response;
        if (health->Check(&call, {}, &response).ok())
            probed_at_ = Clock::now().time_since_epoch().count();
        lock.lock();
    } while (!prober_wake_.wait_for(lock, probe_period, [this] { return !serving_; }));
}

void GrpcServer::wake() {
    for (const auto& shard : shards_) shard->wake();
}

// gRPC's Shutdown() sends GOAWAY at once, and returns when all calls have ended or the timeout has
// passed.
void GrpcServer::drain(Clock::duration timeout) {
    if (!serving_.exchange(false) || !server_) return;
    { const std::lock_guard lock(prober_mutex_); }
    prober_wake_.notify_all();
    if (prober_.joinable()) prober_.join();
    acceptor_.stop();
    ASSERT(!shutdown_.joinable());
    shutdown_ = std::thread([this, timeout] {
        // Notify health watchers first.
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        server_->Shutdown(std::chrono::system_clock::now() + timeout + shutdown_timeout);
    });
}

void GrpcServer::stop() {
    if (stopped_) return;
    stopped_ = true;
    drain({});
    // The shards and the dispatcher still run and drain the events of their calls. Cancelling all
    // calls ends a drain in progress.
    if (server_) grpc_server_cancel_all_calls(server_->c_server());
    if (shutdown_.joinable()) shutdown_.join();
    dispatcher_.stop();
    for (const auto& shard : shards_) shard->stop();
    relay_.stop(shutdown_flush_max);
}

}  // namespace jostle::server
