// SPDX-License-Identifier: MIT
#include "server/app/server_app.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <mutex>
#include <optional>
#include <random>

#include "jostle/scenes/scene_file.h"
#include "server/app/maintenance_thread.h"
#include "server/app/service_manager.h"
#include "server/app/shutdown.h"
#include "server/app/shutdown_watchdog.h"
#include "server/config/exposure.h"
#include "server/grpc/admin_methods.h"
#include "server/grpc/grpc_server.h"
#include "server/grpc/query_methods.h"
#include "server/grpc/world_methods.h"
#include "server/http/admin_routes.h"
#include "server/http/http_routes.h"
#include "server/http/http_server.h"
#include "server/recovery/world_archive.h"
#include "server/services/query_control.h"
#include "server/services/world_control.h"
#include "server/tls/certificate_store.h"
#include "server/util/log.h"
#include "server/world/tick_watchdog.h"

namespace jostle::server {
namespace {

// From the end of the drain: sockets, threads and worlds are taken down within this, or else.
constexpr auto graceful_shutdown_max = std::chrono::milliseconds(2500);
// ... of which the last checkpoints may take so long. Without them the journal says all.
constexpr auto flush_timeout = std::chrono::milliseconds(1800);

// Frames come before the transports exist and go on while those are taken down: the wake-up goes
// through here.
class FrameNotifier {
public:
    void set(GrpcServer* grpc, HttpServer* http_server) {
        const std::lock_guard lock(mutex_);
        grpc_ = grpc;
        http_server_ = http_server;
    }
    void wake() {
        const std::lock_guard lock(mutex_);
        if (grpc_) grpc_->wake();
        if (http_server_) http_server_->wake();
    }

private:
    std::mutex mutex_;
    GrpcServer* grpc_ = nullptr;
    HttpServer* http_server_ = nullptr;
};

std::vector<std::string> stage_names() {
    std::vector<std::string> names;
    for (int i = 0; i < physics::stage_count; i++)
        names.emplace_back(physics::stage_name(static_cast<physics::Stage>(i)));
    return names;
}

WorldHostSettings host_settings(const Config& config, FrameNotifier& wakers, Metrics& metrics) {
    const SceneLimits& scene = config.scene;
    return {.limits = {.scene = {.bodies_max = config.world.bodies_max,
                                 .joints_max = scene.joints_max,
                                 .joints_per_pair_max = scene.joints_per_pair_max,
                                 .geometry_bytes_max = scene.geometry_bytes_max,
                                 .body_geometry_bytes_max = scene.body_geometry_bytes_max,
                                 .work_per_second_max = scene.work_per_second_max,
                                 .first_step_seconds_max = scene.first_step_seconds_max},
                       .bodies_owned_max = config.client.bodies_owned_max,
                       .lag_compensation_ms_max = config.tick.lag_compensation_ms_max},
            .totals = {.bodies_max = config.world.bodies_total_max,
                       .work_per_second_max = scene.work_total_per_second_max},
            .command_queue_max = config.world.command_queue_max,
            .catch_up_ticks_max = config.tick.catch_up_ticks_max,
            .physics_threads = config.tick.physics_threads,
            .on_frame =
                [&wakers](bool has_events) {
                    if (has_events) wakers.wake();
                },
            .metrics = &metrics};
}

// Before the metrics are read.
void refresh_metrics(Metrics& metrics, const CertificateStore* certificates) {
    raise_to(metrics.log_dropped, static_cast<double>(log_lines_dropped()));
    if (!certificates) return;
    const double expiry =
        static_cast<double>(std::chrono::system_clock::to_time_t(certificates->expiry()));
    for (const char* listener : {"grpc", "http"})
        metrics.certificate_expiry.Add({{"listener", listener}}).Set(expiry);
}

// Few and small: Prometheus, a probe, an operator or two.
// Beyond this machine it asks for certificates where there is an authority for them.
HttpServerSettings admin_settings(const Config& config, const Metrics& metrics,
                                  const CertificateStore* certificates) {
    const HostPort address = *parse_host_port(config.admin);
    const bool asks = !config.tls.client_ca.empty() && !is_loopback(address.host);
    return {.host = address.host,
            .port = address.port,
            .flag = "--admin",
            .metrics = &metrics.listener(Listener::admin),
            .certificates = asks ? certificates : nullptr,
            .require_certificates = asks,
            .connections_max = 32,
            .per_address_max = 32,
            .small_body_bytes_max = 1024,
            .work_queue_max = AdminControl::waiting_max,
            .query_threads = AdminControl::waiting_max};
}

DatagramServerSettings datagram_settings(const Config& config, Metrics& metrics) {
    const HostPort address = *parse_host_port(config.datagrams.listen);
    return {.host = address.host,
            .port = address.port,
            .advertised_port = static_cast<std::uint16_t>(config.datagrams.advertised_port),
            .metrics = &metrics};
}

// "pyramid", "my.json" or, for a name of its own, "arena=pyramid".
Status start_worlds(const Config& config, WorldDirectory& worlds) {
    for (const std::string& wanted : config.scenes) {
        const auto failed = [&](const Error& error) {
            return Error{error.code, fmt::format("scene \"{}\": {}", wanted, error.message)};
        };
        const std::size_t equals = wanted.find('=');
        const bool named = equals != std::string::npos;
        if (named && worlds.find(wanted.substr(0, equals))) continue;  // it goes on
        const auto scene = scenes::load_scene(named ? wanted.substr(equals + 1) : wanted);
        if (!scene.ok()) return failed(scene.error());
        if (!named && worlds.find(scene->name)) continue;
        if (const auto world = worlds.create(named ? wanted.substr(0, equals) : "", *scene);
            !world.ok())
            return failed(world.error());
    }
    return {};
}

// Worlds that were there go on, and who played in them may come back.
void go_on(WorldArchive& archive, PlayContext& context) {
    const Clock::time_point until =
        Clock::now() + from_seconds(context.config.client.resume_timeout_seconds);
    for (PersistedWorld& kept : archive.take_worlds()) {
        const auto world = context.worlds.adopt(std::move(kept.start));
        for (const PreviousClient& absent : kept.previous_clients)
            expect_resume(context, world, absent.client, absent.last_sequence, until);
    }
}

// What tells this process's worlds from those of another one behind the same address.
std::string process_suffix() {
    std::random_device random;
    return fmt::format("{:08x}", static_cast<std::uint32_t>(random()));
}

// Below what the process can have, of which HTTP, worlds and files take their part.
ConnectionTableLimits connection_limits(const ConnectionLimits& wanted) {
    rlimit limit{};
    const bool known = getrlimit(RLIMIT_NOFILE, &limit) == 0;
    constexpr rlim_t others = 1200;
    const rlim_t most = known && limit.rlim_cur > 2 * others ? limit.rlim_cur - others
                        : known                              ? limit.rlim_cur / 2
                                                             : 512;
    constexpr rlim_t of_connection = 3;  // the client's, and a pair towards gRPC
    return {.total_max = std::min(static_cast<std::size_t>(wanted.total_max),
                                  static_cast<std::size_t>(most / of_connection)),
            .per_address_max = static_cast<std::size_t>(wanted.per_address_max)};
}

// As many descriptors as the system lets us have: running out of them deafens a server.
void raise_descriptor_limit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == limit.rlim_max) return;
    limit.rlim_cur = limit.rlim_max;
    if (setrlimit(RLIMIT_NOFILE, &limit) != 0)
        log_warn("cannot raise the limit of open files above {}", limit.rlim_cur);
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

// What others type to reach a server that listens there.
std::string reachable(const std::string& host, const std::string& advertised_host) {
    if (!advertised_host.empty()) return advertised_host;
    if (host == "0.0.0.0" || host == "::") {
        char name[256] = {};
        return gethostname(name, sizeof name - 1) == 0 ? name : "localhost";
    }
    return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

struct Ports {
    int grpc = 0, http = 0, admin = 0, datagrams = 0;  // the last two 0: there is none
};

Status write_ports(const std::string& path, const Ports& ports) {
    if (path.empty()) return {};
    // Written aside and renamed: whoever waits for the file never reads half of it.
    const std::string aside = path + ".new";
    std::ofstream out(aside);
    out << "{\"grpc\": " << ports.grpc << ", \"http\": " << ports.http;
    if (ports.admin != 0) out << ", \"admin\": " << ports.admin;
    if (ports.datagrams != 0) out << ", \"datagrams\": " << ports.datagrams;
    out << "}\n";
    out.close();
    if (!out || std::rename(aside.c_str(), path.c_str()) != 0)
        return Error{ErrorCode::unavailable, "cannot write the port file " + path};
    return {};
}

}  // namespace

int run_server(const Config& config, const std::string& port_file, const std::string& version) {
    Shutdown shutdown;
    Metrics metrics(version, stage_names());
    metrics.clients_max.Set(config.world.clients_max);
    RpcMetrics rpc_metrics(metrics);
    FrameNotifier wakers;
    SessionDirectory sessions(config.world.clients_max, config.world.clients_per_address_max);
    raise_descriptor_limit();
    const auto failed = [](const Error& error) {
        log_error("{}", error.message);
        return 1;
    };
    WorldHostSettings hosts = host_settings(config, wakers, metrics);
    std::unique_ptr<WorldArchive> archive;  // outlives the worlds
    if (config.persistence.is_on()) {
        auto opened_archive = WorldArchive::open(config.persistence, hosts.limits,
                                                 hosts.physics_threads, [&] { wakers.wake(); });
        if (!opened_archive.ok()) return failed(opened_archive.error());
        archive = *std::move(opened_archive);
        hosts.world_persistence = archive.get();
        sessions.use_ids(archive->first_client(), [&](ClientId next) { archive->on_client(next); });
    }
    WorldDirectory worlds(hosts, config.world.worlds_max, process_suffix());
    if (!config.development.network_conditions.empty())
        log_warn(
            "development.network_conditions makes the link to every client worse on purpose: {}",
            config.development.network_conditions);

    const auto opened = Authorizer::open(config);
    if (!opened.ok()) return failed(opened.error());
    Authorizer& authorizer = **opened;
    std::unique_ptr<CertificateStore> certificates;
    if (!config.tls.certificate.empty()) {
        auto store = CertificateStore::open(config.tls, std::chrono::system_clock::now());
        if (!store.ok()) return failed(store.error());
        certificates = *std::move(store);
    }
    std::optional<DatagramServer> datagrams;
    if (!config.datagrams.listen.empty()) {
        datagrams.emplace(datagram_settings(config, metrics));
        if (Status s = datagrams->start(); !s.ok()) return failed(s.error());
    }
    PlayContext context{.config = config,
                        .worlds = worlds,
                        .sessions = sessions,
                        .authorizer = authorizer,
                        .metrics = &metrics,
                        .rpc_metrics = &rpc_metrics,
                        .datagrams = datagrams ? &*datagrams : nullptr};
    worlds.on_replaced(
        [&](const std::shared_ptr<WorldHost>& world, const std::vector<ClientId>& clients) {
            reconcile_clients(context, *world, clients);
        });
    TickWatchdog watch(worlds, {.step_max = from_seconds(config.tick.step_seconds_max)});
    if (archive) {
        context.resume_registry.use_secret(archive->secret());
        go_on(*archive, context);
    }
    if (Status s = start_worlds(config, worlds); !s.ok()) return failed(s.error());
    WorldControl control(context);
    const QueryControl queries(context);
    const GrpcServer* grpc_to_ask = nullptr;  // before the gateway starts
    const auto not_ready_reason = [&]() -> std::optional<std::string> {
        if (context.draining) return "the server is going down";
        const auto unkept = archive ? archive->failure_reason() : std::nullopt;
        if (unkept) return "no input is taken, for it could not be kept: " + *unkept;
        return std::nullopt;
    };
    const auto failure_reason = [&]() -> std::optional<std::string> {
        const Clock::time_point now = Clock::now();
        if (!watch.all_worlds_tick(now)) return "a tick hangs";
        return grpc_to_ask ? grpc_to_ask->failure_reason(now) : std::nullopt;
    };
    const HttpRoutes routes(control, queries,
                            {.web_root = find_web_root(config.web_root),
                             .allowed_origins = config.allowed_origins,
                             .allowed_hosts = config.allowed_hosts,
                             .not_ready_reason = not_ready_reason,
                             .failure_reason = failure_reason});
    AdminControl admin_control(context);
    const AdminRoutes admin_routes(
        admin_control, metrics,
        {.allowed_hosts = config.allowed_hosts,
         .not_ready_reason = not_ready_reason,
         .failure_reason = failure_reason,
         .refresh = [&] { refresh_metrics(metrics, certificates.get()); }});
    const HostPort listen = *parse_host_port(config.listen), http = *parse_host_port(config.http);
    std::vector<CallMethod> methods = world_methods(control, worlds);
    std::ranges::move(query_methods(queries, worlds), std::back_inserter(methods));
    std::ranges::move(admin_methods(admin_control, worlds), std::back_inserter(methods));
    const auto is_healthy = [&] { return watch.all_worlds_tick(Clock::now()); };
    GrpcServer grpc(context, std::move(methods), is_healthy,
                    {.host = listen.host,
                     .port = listen.port,
                     .network_threads = config.network_threads,
                     .certificates = certificates.get(),
                     .connections = connection_limits(config.connection),
                     .relay = {.buffered_bytes_max = config.connection.buffered_bytes_max,
                               .buffered_total_max = config.connection.buffered_total_bytes_max},
                     .metrics = &metrics.listener(Listener::grpc),
                     .tcp_user_timeout = from_seconds(config.stream.client_timeout_seconds),
                     .idle_max = from_seconds(config.connection.idle_timeout_seconds)});
    HttpServer http_server(
        context, routes,
        {.host = http.host,
         .port = http.port,
         .metrics = &metrics.listener(Listener::http),
         .certificates = certificates.get(),
         .per_address_max = static_cast<std::size_t>(config.connection.per_address_max),
         .message_bytes_max = static_cast<std::size_t>(config.client.message_bytes_max)});
    if (Status s = grpc.start(); !s.ok()) return failed(s.error());
    grpc_to_ask = &grpc;
    if (Status s = http_server.start(); !s.ok()) return failed(s.error());
    std::optional<HttpServer> admin;
    if (!config.admin.empty()) {
        admin.emplace(context, admin_routes, admin_settings(config, metrics, certificates.get()));
        if (Status s = admin->start(); !s.ok()) return failed(s.error());
    }
    const int admin_port = admin ? admin->port() : 0;
    const std::string web =
        fmt::format("{}:{}", reachable(http.host, config.advertised_host), http_server.port());
    control.set_addresses(
        {.grpc = fmt::format("{}:{}", reachable(listen.host, config.advertised_host), grpc.port()),
         .websocket = (certificates ? "wss://" : "ws://") + web + "/play"});
    wakers.set(&grpc, &http_server);
    const int datagram_port = datagrams ? datagrams->port() : 0;
    if (Status s =
            write_ports(port_file, {grpc.port(), http_server.port(), admin_port, datagram_port});
        !s.ok()) {
        wakers.set(nullptr, nullptr);
        return failed(s.error());
    }
    log_info("gRPC on {}:{}, viewer at {}://{}", listen.host, grpc.port(),
             certificates ? "https" : "http", web);
    if (datagrams) log_info("datagrams at port {}, UDP", datagram_port);
    if (admin)
        log_info("metrics at http://{}:{}/metrics",
                 reachable(parse_host_port(config.admin)->host, {}), admin_port);

    {
        const auto now_and_then = [&] { remove_expired_clients(context, Clock::now()); };
        const MaintenanceThread maintenance_thread(
            authorizer, certificates.get(), now_and_then, [&] {
                const Clock::time_point now = Clock::now();
                return watch.all_worlds_tick(now) && !grpc.failure_reason(now);
            });
        notify_ready(fmt::format("gRPC on {}:{}, {} worlds", listen.host, grpc.port(),
                                 worlds.list().size()));
        shutdown.wait(config.drain_timeout_seconds, grpc, http_server, context);
    }

    const ShutdownWatchdog hard_exit(graceful_shutdown_max);
    wakers.set(nullptr, nullptr);
    if (datagrams) datagrams->stop();  // before those whom it wakes
    admin_control.stop();
    http_server.stop();
    grpc.stop();
    if (admin) admin->stop();  // late: who watches sees the end
    worlds.stop_all();
    if (archive && !archive->flush(flush_timeout))
        log_error("not all could be kept: {}",
                  archive->failure_reason().value_or("the store is slow"));
    log_info("done");
    return 0;
}

}  // namespace jostle::server
