// SPDX-License-Identifier: MIT
#include "server/app/listener_settings.h"

#include <spdlog/fmt/fmt.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "server/config/exposure.h"
#include "server/services/admin_control.h"
#include "server/util/log.h"

namespace jostle::server {

namespace {

// Each connection takes file descriptors; HTTP, worlds and files need the reserved ones.
ConnectionTableLimits connection_limits(const ConnectionLimits& configured) {
    constexpr rlim_t reserved = 1200;
    constexpr rlim_t per_connection = 3;  // the client's socket and a pair of sockets to gRPC
    rlimit limit{};
    rlim_t available = 512;
    if (getrlimit(RLIMIT_NOFILE, &limit) == 0)
        available = limit.rlim_cur > 2 * reserved ? limit.rlim_cur - reserved : limit.rlim_cur / 2;
    return {.total_max = std::min(static_cast<std::size_t>(configured.total_max),
                                  static_cast<std::size_t>(available / per_connection)),
            .per_address_max = static_cast<std::size_t>(configured.per_address_max)};
}

bool uses_proxy_protocol(const Config& config, std::string_view port) {
    return std::ranges::find(config.proxy_protocol, port) != config.proxy_protocol.end();
}

}  // namespace

WorldHostSettings world_settings(const Config& config, Metrics& metrics,
                                 std::function<void(bool has_events)> on_frame) {
    const SceneLimits& scene = config.scene;
    return {.limits = {.scene = {.bodies_max = config.world.bodies_max,
                                 .joints_max = scene.joints_max,
                                 .joints_per_pair_max = scene.joints_per_pair_max,
                                 .geometry_bytes_max = scene.geometry_bytes_max,
                                 .body_geometry_bytes_max = scene.body_geometry_bytes_max,
                                 .work_per_second_max = scene.work_per_second_max,
                                 .pairs_per_shape_max = scene.pairs_per_shape_max,
                                 .first_step_seconds_max = scene.first_step_seconds_max},
                       .bodies_owned_max = config.client.bodies_owned_max,
                       .joints_owned_max = config.client.joints_owned_max,
                       .lag_compensation_ms_max = config.tick.lag_compensation_ms_max,
                       .attributes = {.per_target_max = config.world.attributes_per_target_max,
                                      .text_bytes_max = config.world.attribute_text_bytes_max,
                                      .client_bytes_max = config.client.attribute_bytes_max,
                                      .world_bytes_max = config.world.attribute_bytes_max}},
            .totals = {.bodies_max = config.world.bodies_total_max,
                       .work_per_second_max = scene.work_total_per_second_max},
            .command_queue_max = config.world.command_queue_max,
            .inputs = {.tick_share = config.tick.input_share,
                       .wait_seconds_max = config.tick.input_wait_seconds_max},
            .query_copy_share = config.tick.query_copy_share,
            .user_message_bytes_per_second = config.world.user_message_bytes_per_second,
            .body_limits = {.account_bodies_max = config.client.account_bodies_max,
                            .spawn_load_max = config.world.spawn_load_max,
                            .retained_seconds = config.client.retained_bodies_seconds},
            .catch_up_ticks_max = config.tick.catch_up_ticks_max,
            .physics_threads = config.tick.physics_threads,
            .on_frame = std::move(on_frame),
            .metrics = &metrics};
}

GrpcSettings grpc_settings(const Config& config, Metrics& metrics,
                           const CertificateStore* certificates, const TrustedProxies* proxies) {
    const HostPort address = *parse_host_port(config.listen);
    return {.host = address.host,
            .port = address.port,
            .network_threads = config.network_threads,
            .certificates = certificates,
            .proxies = proxies,
            .proxy_protocol = uses_proxy_protocol(config, "grpc"),
            .message_bytes_max = config.scene.request_bytes_max,
            .connections = connection_limits(config.connection),
            .relay = {.buffered_bytes_max = config.connection.buffered_bytes_max,
                      .buffered_total_max = config.connection.buffered_total_bytes_max},
            .metrics = &metrics.listener(Listener::grpc),
            .tcp_user_timeout = from_seconds(config.stream.client_timeout_seconds),
            .idle_max = from_seconds(config.connection.idle_timeout_seconds)};
}

HttpServerSettings http_settings(const Config& config, Metrics& metrics,
                                 const CertificateStore* certificates,
                                 const TrustedProxies* proxies) {
    const HostPort address = *parse_host_port(config.http);
    return {.host = address.host,
            .port = address.port,
            .metrics = &metrics.listener(Listener::http),
            .certificates = certificates,
            .proxies = proxies,
            .proxy_protocol = uses_proxy_protocol(config, "http"),
            .per_address_max = static_cast<std::size_t>(config.connection.per_address_max),
            .body_bytes_max = static_cast<std::size_t>(config.scene.request_bytes_max),
            // Of all connections together: one scene of the maximum size and many small requests.
            .bodies_bytes_max = config.scene.request_bytes_max + 16e6,
            .message_bytes_max = static_cast<std::size_t>(config.client.message_bytes_max)};
}

HttpServerSettings admin_settings(const Config& config, Metrics& metrics,
                                  const CertificateStore* certificates) {
    const HostPort address = *parse_host_port(config.admin);
    const bool requires_certificate = !config.tls.client_ca.empty() && !is_loopback(address.host);
    return {.host = address.host,
            .port = address.port,
            .flag = "--admin",
            .metrics = &metrics.listener(Listener::admin),
            .certificates = requires_certificate ? certificates : nullptr,
            .require_certificates = requires_certificate,
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

void raise_descriptor_limit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == limit.rlim_max) return;
    limit.rlim_cur = limit.rlim_max;
    if (setrlimit(RLIMIT_NOFILE, &limit) != 0)
        log_warn("cannot raise the limit of open files to {}: {}", limit.rlim_max,
                 std::strerror(errno));
}

std::filesystem::path find_web_root(const std::string& configured) {
    std::error_code error;
    if (std::filesystem::exists(configured, error)) return configured;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error) return configured;
    const std::filesystem::path prefix = program.parent_path().parent_path();
    for (const std::filesystem::path& candidate :
         {prefix.parent_path().parent_path() / configured, prefix / "share" / "jostle" / "web"})
        if (std::filesystem::exists(candidate, error)) return candidate;
    return configured;
}

Status check_web_root(const Config& config) {
    const std::string& configured = config.web_root;
    if (configured == Config{}.web_root || config.http.empty()) return {};
    std::error_code error;
    const std::filesystem::path folder = find_web_root(configured);
    if (std::filesystem::is_regular_file(folder / "index.html", error)) return {};
    const char* const reason = std::filesystem::is_directory(folder, error)
                                   ? "contains no index.html"
                                   : "is not a directory";
    return Error{
        ErrorCode::invalid_argument,
        fmt::format("web_root: \"{}\" {}; it must be a directory with the built viewer, such "
                    "as clients/web/dist",
                    folder.string(), reason)};
}

std::string reachable_host(const std::string& host, const std::string& advertised_host) {
    if (!advertised_host.empty()) return advertised_host;
    if (host == "0.0.0.0" || host == "::") {
        char name[256] = {};
        return gethostname(name, sizeof name - 1) == 0 ? name : "localhost";
    }
    return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

}  // namespace jostle::server
