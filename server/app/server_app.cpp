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
#include "gateway/gateway.h"
#include "jostle/scenes/scene_file.h"
#include "protocol/query_control.h"
#include "protocol/world_control.h"
#include "rpc/grpc_server.h"

namespace jostle::server {
namespace {

namespace asio = boost::asio;

constexpr auto poll_period = std::chrono::milliseconds(20);
constexpr auto goodbye_time = std::chrono::milliseconds(100);

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

WorldHostSettings host_settings(const Config& config, Wakers& wakers) {
    return {.limits = {.bodies_max = config.world.bodies_max,
                       .bodies_owned_max = config.client.bodies_owned_max},
            .command_queue_max = config.world.command_queue_max,
            .catch_up_max = config.tick.catch_up_max,
            .physics_threads = config.tick.physics_threads,
            .on_frame = [&wakers] { wakers.wake(); }};
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

Status write_ports(const std::string& path, int grpc_port, int http_port) {
    if (path.empty()) return {};
    // Written aside and renamed: whoever waits for the file never reads half of it.
    const std::string aside = path + ".new";
    std::ofstream out(aside);
    out << "{\"grpc\": " << grpc_port << ", \"http\": " << http_port << "}\n";
    out.close();
    if (!out || std::rename(aside.c_str(), path.c_str()) != 0)
        return Error{ErrorCode::unavailable, "cannot write the port file " + path};
    return {};
}

// Waits for the first signal, then gives clients the time to leave; a second signal ends the wait.
class Shutdown {
public:
    Shutdown(double drain_seconds, GrpcServer& grpc, Gateway& gateway, PlayContext& context)
        : drain_(from_seconds(drain_seconds)), grpc_(grpc), gateway_(gateway), context_(context) {}

    void wait() {
        signals_.async_wait([this](const boost::system::error_code&, int) { begin(); });
        io_.run();
    }

private:
    void begin() {
        log_info("going down: telling {} clients", context_.sessions.clients());
        context_.draining = true;
        grpc_.drain();
        grpc_.wake();
        gateway_.wake();
        signals_.async_wait([this](const boost::system::error_code& error, int) {
            if (!error) io_.stop();
        });
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
    asio::steady_timer timer_{io_};
    Clock::time_point deadline_{};
};

}  // namespace

int run_server(const Config& config, const std::string& port_file) {
    Wakers wakers;
    SessionDirectory sessions(config.world.clients_max);
    WorldDirectory worlds(host_settings(config, wakers), config.world.worlds_max);
    const auto failed = [](const Error& error) {
        log_error("{}", error.message);
        return 1;
    };
    if (Status s = start_worlds(config, worlds); !s.ok()) return failed(s.error());

    PlayContext context{.config = config, .worlds = worlds, .sessions = sessions};
    WorldControl control(context);
    const QueryControl queries(context);
    const HttpRoutes routes(control, queries,
                            {.web_root = find_web_root(config.web_root),
                             .allowed_origins = config.allowed_origins,
                             .is_ready = [&] { return !context.draining.load(); }});
    const HostPort listen = *parse_host_port(config.listen), http = *parse_host_port(config.http);
    GrpcServer grpc(
        context, control, queries,
        {.host = listen.host, .port = listen.port, .network_threads = config.network_threads});
    Gateway gateway(
        context, routes,
        {.host = http.host,
         .port = http.port,
         .message_bytes_max = static_cast<std::size_t>(config.client.message_bytes_max)});
    if (Status s = grpc.start(); !s.ok()) return failed(s.error());
    if (Status s = gateway.start(); !s.ok()) return failed(s.error());
    const std::string web = fmt::format("{}:{}", reachable(http.host), gateway.port());
    control.set_addresses({.grpc = fmt::format("{}:{}", reachable(listen.host), grpc.port()),
                           .websocket = "ws://" + web + "/play"});
    wakers.set(&grpc, &gateway);
    if (Status s = write_ports(port_file, grpc.port(), gateway.port()); !s.ok()) {
        wakers.set(nullptr, nullptr);
        return failed(s.error());
    }
    log_info("gRPC on {}:{}, viewer at http://{}", listen.host, grpc.port(), web);

    Shutdown(config.drain_seconds, grpc, gateway, context).wait();

    wakers.set(nullptr, nullptr);
    gateway.stop();
    grpc.stop();
    worlds.stop_all();
    log_info("done");
    return 0;
}

}  // namespace jostle::server
