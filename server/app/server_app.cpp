// SPDX-License-Identifier: MIT
#include "app/server_app.h"

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <mutex>

#include "base/log.h"
#include "gateway/admin_routes.h"
#include "gateway/gateway.h"
#include "gateway/http_routes.h"
#include "jostle/scenes/scene_file.h"
#include "protocol/query_control.h"
#include "protocol/world_control.h"
#include "rpc/grpc_server.h"
#include "rpc/method_list.h"

namespace jostle::server {
namespace {

namespace asio = boost::asio;

constexpr auto poll_period = std::chrono::milliseconds(20);
constexpr auto goodbye_time = std::chrono::milliseconds(100);
constexpr auto hung_after = std::chrono::seconds(2);  // a world without a frame for so long

// Frames come before the transports exist and go on while those are taken down: the wake-up goes
// through here.
class Wakers {
public:
    void set(GrpcServer* grpc, Gateway* gateway) {
        const std::lock_guard lock(mutex_);
        grpc_ = grpc;
        gateway_ = gateway;
    }
    void wake() {
        const std::lock_guard lock(mutex_);
        if (grpc_) grpc_->wake();
        if (gateway_) gateway_->wake();
    }

private:
    std::mutex mutex_;
    GrpcServer* grpc_ = nullptr;
    Gateway* gateway_ = nullptr;
};

std::vector<std::string> stage_names() {
    std::vector<std::string> names;
    for (int i = 0; i < physics::stage_count; i++)
        names.emplace_back(physics::stage_name(static_cast<physics::Stage>(i)));
    return names;
}

WorldHostSettings host_settings(const Config& config, Wakers& wakers, Metrics& metrics) {
    return {.limits = {.bodies_max = config.world.bodies_max,
                       .bodies_owned_max = config.client.bodies_owned_max},
            .command_queue_max = config.world.command_queue_max,
            .catch_up_max = config.tick.catch_up_max,
            .physics_threads = config.tick.physics_threads,
            .on_frame = [&wakers] { wakers.wake(); },
            .metrics = &metrics};
}

// Whether every world has shown a frame of late.
bool all_tick(const WorldDirectory& worlds, Clock::time_point now) {
    for (const auto& world : worlds.list())
        if (now - world->frame()->due > hung_after) return false;
    return true;
}

// Few and small: Prometheus, a probe, an operator or two.
GatewaySettings admin_settings(const HostPort& address, const Metrics& metrics) {
    return {.host = address.host,
            .port = address.port,
            .flag = "--admin",
            .metrics = &metrics.listener(Listener::admin),
            .connections_max = 32,
            .body_bytes_max = 1024,
            .slow_requests_max = AdminControl::waiting_max,
            .workers = AdminControl::waiting_max};
}

Status start_worlds(const Config& config, WorldDirectory& worlds) {
    for (const std::string& name : config.scenes) {
        const auto failed = [&](const Error& error) {
            return Error{error.code, fmt::format("scene \"{}\": {}", name, error.message)};
        };
        const auto scene = scenes::load_scene(name);
        if (!scene.ok()) return failed(scene.error());
        if (const auto world = worlds.create({}, *scene); !world.ok()) return failed(world.error());
    }
    return {};
}

// As given; when that leads nowhere from the current folder, as seen from the project that the
// program was built in, or where the viewer is installed with it.
std::filesystem::path find_web_root(const std::string& given) {
    std::error_code error;
    if (std::filesystem::exists(given, error)) return given;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error) return given;
    const std::filesystem::path prefix = program.parent_path().parent_path();
    for (const std::filesystem::path& place :
         {prefix.parent_path().parent_path() / given, prefix / "share" / "jostle" / "web"})
        if (std::filesystem::exists(place, error)) return place;
    return given;
}

// What a person types to reach a server that listens on all addresses.
std::string reachable(const std::string& host) {
    if (host == "0.0.0.0" || host == "::") return "localhost";
    return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

Status write_ports(const std::string& path, int grpc_port, int http_port, int admin_port) {
    if (path.empty()) return {};
    // Written aside and renamed: whoever waits for the file never reads half of it.
    const std::string aside = path + ".new";
    std::ofstream out(aside);
    out << "{\"grpc\": " << grpc_port << ", \"http\": " << http_port;
    if (admin_port != 0) out << ", \"admin\": " << admin_port;
    out << "}\n";
    out.close();
    if (!out || std::rename(aside.c_str(), path.c_str()) != 0)
        return Error{ErrorCode::unavailable, "cannot write the port file " + path};
    return {};
}

// Waits for the first signal, or for an operator's word, then gives clients the time to leave; a
// further signal ends the wait.
class Shutdown {
public:
    Shutdown(double drain_seconds, GrpcServer& grpc, Gateway& gateway, PlayContext& context)
        : drain_(from_seconds(drain_seconds)), grpc_(grpc), gateway_(gateway), context_(context) {}

    void wait() {
        await_signal();
        await_operator();
        io_.run();
    }

private:
    void await_signal() {
        signals_.async_wait([this](const boost::system::error_code& error, int) {
            if (error) return;
            if (begun_) return io_.stop();
            begin();
            await_signal();
        });
    }
    void await_operator() {
        if (begun_) return;
        if (context_.drain_asked) return begin();
        operator_timer_.expires_after(poll_period);
        operator_timer_.async_wait([this](const boost::system::error_code&) { await_operator(); });
    }
    void begin() {
        begun_ = true;
        log_info("going down: telling {} clients", context_.sessions.clients());
        context_.draining = true;
        grpc_.drain();
        grpc_.wake();
        gateway_.wake();
        deadline_ = Clock::now() + drain_;
        wait_for_clients();
    }
    void wait_for_clients() {
        if (context_.sessions.clients() == 0 || Clock::now() >= deadline_) return finish();
        timer_.expires_after(poll_period);
        timer_.async_wait([this](const boost::system::error_code&) { wait_for_clients(); });
    }

    // What is still there is told that it is over, and given a moment to hear it.
    void finish() {
        context_.closing = true;
        grpc_.wake();
        gateway_.wake();
        timer_.expires_after(goodbye_time);
        timer_.async_wait([this](const boost::system::error_code&) { io_.stop(); });
    }

    const Clock::duration drain_;
    GrpcServer& grpc_;
    Gateway& gateway_;
    PlayContext& context_;
    asio::io_context io_{1};
    asio::signal_set signals_{io_, SIGTERM, SIGINT};
    asio::steady_timer timer_{io_}, operator_timer_{io_};
    bool begun_ = false;
    Clock::time_point deadline_{};
};

}  // namespace

int run_server(const Config& config, const std::string& port_file, const std::string& version) {
    Metrics metrics(version, stage_names());
    metrics.clients_max.Set(config.world.clients_max);
    RpcMetrics rpc_metrics(metrics, unary_methods_of(served_services()),
                           streaming_methods_of(served_services()));
    Wakers wakers;
    SessionDirectory sessions(config.world.clients_max);
    WorldDirectory worlds(host_settings(config, wakers, metrics), config.world.worlds_max);
    const auto failed = [](const Error& error) {
        log_error("{}", error.message);
        return 1;
    };
    if (Status s = start_worlds(config, worlds); !s.ok()) return failed(s.error());

    PlayContext context{.config = config,
                        .worlds = worlds,
                        .sessions = sessions,
                        .metrics = &metrics,
                        .rpc_metrics = &rpc_metrics};
    WorldControl control(context);
    const QueryControl queries(context);
    const HttpRoutes routes(control, queries,
                            {.web_root = find_web_root(config.web_root),
                             .allowed_origins = config.allowed_origins,
                             .is_ready = [&] { return !context.draining.load(); }});
    AdminControl admin_control(context);
    const AdminRoutes admin_routes(admin_control, metrics,
                                   {.is_healthy = [&] { return all_tick(worlds, Clock::now()); },
                                    .is_ready = [&] { return !context.draining.load(); },
                                    .refresh = {}});
    const HostPort listen = *parse_host_port(config.listen), http = *parse_host_port(config.http);
    GrpcServer grpc(context, control, queries,
                    {.host = listen.host,
                     .port = listen.port,
                     .network_threads = config.network_threads,
                     .admin = &admin_control});
    Gateway gateway(
        context, routes,
        {.host = http.host,
         .port = http.port,
         .metrics = &metrics.listener(Listener::http),
         .message_bytes_max = static_cast<std::size_t>(config.client.message_bytes_max)});
    if (Status s = grpc.start(); !s.ok()) return failed(s.error());
    if (Status s = gateway.start(); !s.ok()) return failed(s.error());
    std::optional<Gateway> admin;
    if (!config.admin.empty()) {
        admin.emplace(context, admin_routes,
                      admin_settings(*parse_host_port(config.admin), metrics));
        if (Status s = admin->start(); !s.ok()) return failed(s.error());
    }
    const int admin_port = admin ? admin->port() : 0;
    const std::string web = fmt::format("{}:{}", reachable(http.host), gateway.port());
    control.set_addresses({.grpc = fmt::format("{}:{}", reachable(listen.host), grpc.port()),
                           .websocket = "ws://" + web + "/play"});
    wakers.set(&grpc, &gateway);
    if (Status s = write_ports(port_file, grpc.port(), gateway.port(), admin_port); !s.ok()) {
        wakers.set(nullptr, nullptr);
        return failed(s.error());
    }
    log_info("gRPC on {}:{}, viewer at http://{}", listen.host, grpc.port(), web);
    if (admin)
        log_info("metrics at http://{}:{}/metrics", reachable(parse_host_port(config.admin)->host),
                 admin_port);

    Shutdown(config.drain_seconds, grpc, gateway, context).wait();

    wakers.set(nullptr, nullptr);
    gateway.stop();
    grpc.stop();
    if (admin) admin->stop();  // late: who watches sees the end
    worlds.stop_all();
    log_info("done");
    return 0;
}

}  // namespace jostle::server
