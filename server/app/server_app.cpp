// SPDX-License-Identifier: MIT
#include "server/app/server_app.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <mutex>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "server/app/listener_settings.h"
#include "server/app/maintenance_thread.h"
#include "server/app/service_manager.h"
#include "server/app/shutdown.h"
#include "server/app/start_guard.h"
#include "server/app/start_worlds.h"
#include "server/grpc/grpc_server.h"
#include "server/grpc_web/grpc_web_routes.h"
#include "server/http/admin_api.h"
#include "server/http/admin_routes.h"
#include "server/http/http_routes.h"
#include "server/http/http_server.h"
#include "server/services/call_method.h"
#include "server/services/query_control.h"
#include "server/services/world_control.h"
#include "server/session/empty_rooms.h"
#include "server/util/log.h"
#include "server/world/tick_watchdog.h"

namespace jostle::server {

namespace {

// Closing sockets, threads and worlds after the drain takes at most this long ...
constexpr auto graceful_shutdown_max = std::chrono::milliseconds(2500);
// ... of which writing the last checkpoints takes at most this. Recovery without them replays a
// longer journal.
constexpr auto flush_timeout = std::chrono::milliseconds(1800);

std::vector<std::string> stage_names() {
    std::vector<std::string> names;
    for (int i = 0; i < physics::stage_count; i++)
        names.emplace_back(physics::stage_name(static_cast<physics::Stage>(i)));
    return names;
}

// Distinguishes the world ids of this process from those of another process at the same address.
std::string process_suffix() {
    std::random_device random;
    return fmt::format("{:08x}", static_cast<std::uint32_t>(random()));
}

// Wakes the listeners when a world has published a frame. Worlds publish before the listeners exist
// and while they close, so they wake the listeners through this object. Any thread.
class FrameNotifier {
public:
    // wake() skips a null listener. Returns after a running wake() has ended.
    void set_listeners(GrpcServer* grpc, HttpServer* http) {
        const std::lock_guard lock(mutex_);
        grpc_ = grpc;
        http_ = http;
    }
    void wake() {
        const std::lock_guard lock(mutex_);
        if (grpc_) grpc_->wake();
        if (http_) http_->wake();
    }

private:
    std::mutex mutex_;
    GrpcServer* grpc_ = nullptr;
    HttpServer* http_ = nullptr;
};

// Confirms a fault that lasts: when the process or the machine was stopped, threads look stuck
// until they have run again. Any thread.
class LastingFault {
public:
    bool confirm(bool is_faulty, Clock::time_point now) {
        const std::lock_guard lock(mutex_);
        if (!is_faulty) since_.reset();
        if (is_faulty && !since_) since_ = now;
        return since_ && now - *since_ >= duration_min;
    }

private:
    static constexpr auto duration_min = std::chrono::seconds(2);
    std::mutex mutex_;
    std::optional<Clock::time_point> since_;
};

}  // namespace

// Members are declared in the order in which they start, and each uses only those above it. stop()
// stops them in reverse order.
class ServerApp::Impl {
public:
    Impl(Config config, const Options& options)
        : shutdown_(options.handle_signals),
          config_(std::move(config)),
          metrics_(options.version, stage_names()) {}
    ~Impl() { stop(); }

    Status start();
    void run();
    void drain() { context_->drain_requested = true; }
    void stop();
    const Ports& ports() const { return ports_; }

private:
    Status open_persistence();
    Status open_security();
    Status start_datagrams();
    Status start_worlds();
    Status start_listeners();
    void create_services();
    std::vector<CallMethod> player_methods();
    void announce();

    std::optional<std::string> not_ready_reason() const;
    std::optional<std::string> failure_reason();
    bool is_alive() {
        const Clock::time_point now = Clock::now();
        return !not_alive_.confirm(!watchdog_->is_alive(now), now);
    }
    void refresh_metrics();

    Shutdown shutdown_;  // first, because it catches signals that arrive during the start
    const Config config_;
    Metrics metrics_;
    RpcMetrics rpc_metrics_{metrics_};
    FrameNotifier notifier_;
    SessionDirectory sessions_{config_.world.clients_max, config_.world.clients_per_address_max,
                               config_.limits.sessions_per_subject};
    WorldHostSettings world_settings_;
    std::unique_ptr<WorldArchive> archive_;  // null: worlds end with the process
    std::unique_ptr<WorldDirectory> worlds_;
    std::unique_ptr<Authorizer> authorizer_;
    std::unique_ptr<CertificateStore> certificates_;  // null: no TLS
    TrustedProxies proxies_;
    std::optional<DatagramServer> datagrams_;
    std::unique_ptr<PlayContext> context_;
    std::unique_ptr<TickWatchdog> watchdog_;
    std::optional<WorldControl> world_control_;
    std::optional<QueryControl> query_control_;
    std::optional<AdminControl> admin_control_;
    EmptyRooms empty_rooms_;
    std::optional<GrpcWebRoutes> grpc_web_routes_;
    std::optional<AdminApi> admin_api_;
    std::optional<HttpRoutes> http_routes_;
    std::optional<AdminRoutes> admin_routes_;
    std::optional<GrpcServer> grpc_;
    std::optional<HttpServer> http_;
    std::optional<HttpServer> admin_;
    LastingFault not_alive_, grpc_fault_;
    std::atomic<const GrpcServer*> probed_grpc_{nullptr};  // null: not started
    Ports ports_;
    bool stopped_ = false;
};

Status ServerApp::Impl::start() {
    metrics_.clients_max.Set(config_.world.clients_max);
    raise_descriptor_limit();
    if (!config_.development.network_conditions.empty())
        log_warn("development.network_conditions impairs the network of every client: {}",
                 config_.development.network_conditions);
    world_settings_ = world_settings(config_, metrics_, [this](bool has_events) {
        if (has_events) notifier_.wake();
    });
    if (Status s = open_persistence(); !s.ok()) return s;
    world_settings_.tick_pool = config_.tick.threads > 0
                                    ? std::make_shared<TickPool>(config_.tick.threads)
                                    : TickPool::for_processors();
    worlds_ = std::make_unique<WorldDirectory>(world_settings_, config_.world.worlds_max,
                                               process_suffix());
    if (Status s = open_security(); !s.ok()) return s;
    if (Status s = start_datagrams(); !s.ok()) return s;
    if (Status s = start_worlds(); !s.ok()) return s;
    create_services();
    return start_listeners();
}

Status ServerApp::Impl::open_persistence() {
    if (!config_.persistence.is_on()) return {};
    auto archive =
        WorldArchive::open(config_.persistence, world_settings_.limits,
                           world_settings_.physics_threads, [this] { notifier_.wake(); });
    if (!archive.ok()) return archive.error();
    archive_ = *std::move(archive);
    world_settings_.world_persistence = archive_.get();
    sessions_.use_ids(archive_->first_client(),
                      [this](ClientId next) { archive_->on_client(next); });
    return {};
}

Status ServerApp::Impl::open_security() {
    auto authorizer = Authorizer::open(config_);
    if (!authorizer.ok()) return authorizer.error();
    authorizer_ = *std::move(authorizer);
    auto proxies =
        TrustedProxies::create(config_.trusted_proxies, config_.forwarded_header == "forwarded"
                                                            ? ForwardedHeader::forwarded
                                                            : ForwardedHeader::x_forwarded_for);
    if (!proxies.ok()) return proxies.error();
    proxies_ = *std::move(proxies);
    if (config_.tls.certificate.empty()) return {};
    auto certificates = CertificateStore::open(config_.tls, std::chrono::system_clock::now());
    if (!certificates.ok()) return certificates.error();
    certificates_ = *std::move(certificates);
    return {};
}

Status ServerApp::Impl::start_datagrams() {
    if (config_.datagrams.listen.empty()) return {};
    datagrams_.emplace(datagram_settings(config_, metrics_));
    return datagrams_->start();
}

Status ServerApp::Impl::start_worlds() {
    context_ = std::make_unique<PlayContext>(config_, *worlds_, sessions_, *authorizer_, &metrics_,
                                             &rpc_metrics_, datagrams_ ? &*datagrams_ : nullptr);
    worlds_->on_replaced(
        [this](const std::shared_ptr<WorldHost>& world, const std::vector<ClientId>& clients) {
            reconcile_clients(*context_, *world, clients);
        });
    watchdog_ = std::make_unique<TickWatchdog>(
        *worlds_,
        TickWatchdog::Settings{.tick_cpu_max = from_seconds(config_.tick.step_seconds_max)});
    if (archive_) {
        context_->resume_registry.use_secret(archive_->secret());
        resume_persisted_worlds(*archive_, *context_);
    }
    return create_configured_worlds(config_, *worlds_, archive_.get());
}

void ServerApp::Impl::create_services() {
    const auto not_ready = [this] { return not_ready_reason(); };
    const auto failure = [this] { return failure_reason(); };
    world_control_.emplace(*context_);
    query_control_.emplace(*context_);
    admin_control_.emplace(*context_);
    grpc_web_routes_.emplace(player_methods(), *authorizer_, &rpc_metrics_);
    admin_api_.emplace(*authorizer_, admin_methods(*admin_control_, *worlds_));
    http_routes_.emplace(*world_control_, *query_control_,
                         RouteSettings{.web_root = find_web_root(config_.web_root),
                                       .allowed_origins = config_.allowed_origins,
                                       .allowed_hosts = config_.allowed_hosts,
                                       .not_ready_reason = not_ready,
                                       .failure_reason = failure,
                                       .grpc_web = &*grpc_web_routes_,
                                       .admin_api = &*admin_api_,
                                       .admin_control = &*admin_control_});
    admin_routes_.emplace(*admin_control_, metrics_,
                          AdminRouteSettings{.allowed_hosts = config_.allowed_hosts,
                                             .not_ready_reason = not_ready,
                                             .failure_reason = failure,
                                             .refresh = [this] { refresh_metrics(); }});
}

// The methods of WorldService and QueryService.
std::vector<CallMethod> ServerApp::Impl::player_methods() {
    std::vector<CallMethod> methods = world_methods(
        *world_control_, *worlds_, static_cast<std::size_t>(config_.scene.request_bytes_max));
    std::ranges::move(query_methods(*query_control_, *worlds_), std::back_inserter(methods));
    return methods;
}

Status ServerApp::Impl::start_listeners() {
    std::vector<CallMethod> methods = player_methods();
    std::ranges::move(admin_methods(*admin_control_, *worlds_), std::back_inserter(methods));
    ASSERT(world_control_ && query_control_ && admin_control_ && http_routes_);
    grpc_.emplace(
        *context_, std::move(methods), [this] { return is_alive(); },
        grpc_settings(config_, metrics_, certificates_.get(), &proxies_));
    http_.emplace(*context_, *http_routes_,
                  http_settings(config_, metrics_, certificates_.get(), &proxies_));
    if (Status s = grpc_->start(); !s.ok()) return s;
    probed_grpc_ = &*grpc_;
    if (Status s = http_->start(); !s.ok()) return s;
    if (!config_.admin.empty()) {
        admin_.emplace(*context_, *admin_routes_,
                       admin_settings(config_, metrics_, certificates_.get()));
        if (Status s = admin_->start(); !s.ok()) return s;
    }
    ports_ = {.grpc = grpc_->port(),
              .http = http_->port(),
              .admin = admin_ ? admin_->port() : 0,
              .datagrams = datagrams_ ? datagrams_->port() : 0};
    announce();
    return {};
}

void ServerApp::Impl::announce() {
    ASSERT(grpc_ && http_ && ports_.grpc != 0 && ports_.http != 0);
    const std::string grpc_host = parse_host_port(config_.listen)->host;
    const std::string web = fmt::format(
        "{}:{}", reachable_host(parse_host_port(config_.http)->host, config_.advertised_host),
        ports_.http);
    world_control_->set_addresses(
        {.grpc =
             fmt::format("{}:{}", reachable_host(grpc_host, config_.advertised_host), ports_.grpc),
         .websocket = (certificates_ ? "wss://" : "ws://") + web + "/play"});
    notifier_.set_listeners(&*grpc_, &*http_);
    log_info("gRPC on {}:{}, viewer at {}://{}", grpc_host, ports_.grpc,
             certificates_ ? "https" : "http", web);
    if (datagrams_) log_info("datagrams on UDP port {}", ports_.datagrams);
    if (admin_)
        log_info("metrics at http://{}:{}/metrics",
                 reachable_host(parse_host_port(config_.admin)->host, {}), ports_.admin);
}

void ServerApp::Impl::run() {
    const MaintenanceThread maintenance(
        *authorizer_, certificates_.get(),
        [this] {
            remove_expired_clients(*context_, Clock::now());
            admin_control_->remove_idle_downloads(Clock::now());
            context_->worlds.reset_requested();
            empty_rooms_.close(*context_, Clock::now());
            static_cast<void>(failure_reason());  // also faults that nobody asks for begin to last
        },
        [this] { return !failure_reason(); });
    end_start_guard();
    notify_ready(fmt::format("gRPC on {}:{}, {} worlds", parse_host_port(config_.listen)->host,
                             ports_.grpc, worlds_->list().size()));
    shutdown_.wait(config_.drain_timeout_seconds, *grpc_, *http_, *context_);
}

void ServerApp::Impl::stop() {
    if (std::exchange(stopped_, true)) return;
    const ShutdownWatchdog watchdog(graceful_shutdown_max);
    notifier_.set_listeners(nullptr, nullptr);
    if (datagrams_) datagrams_->stop();  // before the listeners that it wakes
    if (admin_control_) admin_control_->stop();
    if (http_) http_->stop();
    if (grpc_) grpc_->stop();
    if (admin_) admin_->stop();  // the last listener, so that operators can observe the shutdown
    if (worlds_) worlds_->stop_all();
    if (archive_ && !archive_->flush(flush_timeout))
        log_error("cannot write the last checkpoints: {}",
                  archive_->failure_reason().value_or("the database is too slow"));
}

std::optional<std::string> ServerApp::Impl::not_ready_reason() const {
    if (context_->draining) return "the server is shutting down";
    if (archive_ && archive_->damage()) return archive_->damage();
    const auto failure = archive_ ? archive_->failure_reason() : std::nullopt;
    if (failure) return "the server refuses inputs because it cannot persist them: " + *failure;
    return std::nullopt;
}

std::optional<std::string> ServerApp::Impl::failure_reason() {
    if (!is_alive()) return "the process gets no processor time";
    const GrpcServer* const grpc = probed_grpc_;
    const Clock::time_point now = Clock::now();
    const auto reason = grpc ? grpc->failure_reason(now) : std::nullopt;
    return grpc_fault_.confirm(reason.has_value(), now) ? reason : std::nullopt;
}

void ServerApp::Impl::refresh_metrics() {
    raise_to(metrics_.log_dropped, static_cast<double>(log_lines_dropped()));
    metrics_.storage_healthy.Set(1);
    if (archive_) {
        const bool is_healthy = !archive_->damage() && !archive_->failure_reason();
        if (!is_healthy) metrics_.storage_healthy.Set(0);
        metrics_.storage_bytes.Set(static_cast<double>(archive_->bytes_on_disk()));
        metrics_.storage_pending_bytes.Set(static_cast<double>(archive_->pending_bytes()));
        raise_to(metrics_.storage_failures, static_cast<double>(archive_->failures()));
    }
    if (!certificates_) return;
    const double expiry =
        static_cast<double>(std::chrono::system_clock::to_time_t(certificates_->expiry()));
    for (const char* listener : {"grpc", "http"})
        metrics_.certificate_expiry.Add({{"listener", listener}}).Set(expiry);
}

ServerApp::ServerApp(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

ServerApp::~ServerApp() = default;

Result<std::unique_ptr<ServerApp>> ServerApp::start(Config config, const Options& options) {
    if (Status s = check_web_root(config); !s.ok()) return s.error();
    auto impl = std::make_unique<Impl>(std::move(config), options);
    if (Status s = impl->start(); !s.ok()) return s.error();
    return std::unique_ptr<ServerApp>(new ServerApp(std::move(impl)));
}

const Ports& ServerApp::ports() const {
    return impl_->ports();
}

void ServerApp::run() {
    impl_->run();
}

void ServerApp::drain() {
    impl_->drain();
}

void ServerApp::stop() {
    impl_->stop();
}

int run_server(const Config& config, const std::string& port_file, const std::string& version) {
    const auto failed = [](const Error& error) {
        log_error("{}", error.message);
        return 1;
    };
    const auto app = ServerApp::start(config, {.version = version});
    if (!app.ok()) return failed(app.error());
    if (Status s = write_port_file(port_file, (*app)->ports()); !s.ok()) return failed(s.error());
    (*app)->run();
    (*app)->stop();
    log_info("done");
    return 0;
}

}  // namespace jostle::server
