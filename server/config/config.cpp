// SPDX-License-Identifier: MIT
#include "server/config/config.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "jostle/base/network_conditions.h"
#include "server/config/origin.h"
#include "server/util/network.h"

namespace jostle::server {

namespace {

std::string text(double x) {
    std::string s = std::to_string(x);
    while (s.back() == '0') s.pop_back();
    if (s.back() == '.') s.pop_back();
    return s;
}

struct Range {
    template <class Number>
    Range(const char* k, Number v, double lowest, double highest)
        : key(k), value(static_cast<double>(v)), low(lowest), high(highest) {}

    const char* key;
    double value, low, high;
};

Status check_proxies(const Config& c) {
    for (const std::string& origin : c.allowed_origins)
        if (!parse_origin(origin))
            return invalid_argument("allowed_origins: \"" + origin +
                                    "\" is not an origin; write scheme and host without a path, "
                                    "such as https://play.example.org");
    for (const std::string& text : c.trusted_proxies)
        if (const auto network = parse_exact_network(text); !network.ok())
            return invalid_argument("trusted_proxies: " + network.error().message);
    if (c.forwarded_header != "x-forwarded-for" && c.forwarded_header != "forwarded")
        return invalid_argument("forwarded_header is \"" + c.forwarded_header +
                                "\"; it must be x-forwarded-for or forwarded");
    for (const std::string& port : c.proxy_protocol)
        if (port != "grpc" && port != "http")
            return invalid_argument("proxy_protocol: \"" + port +
                                    "\" is not a port; the list may contain grpc and http");
    if (!c.proxy_protocol.empty() && c.trusted_proxies.empty())
        return invalid_argument(
            "proxy_protocol is set without trusted_proxies; list the addresses of the proxies");
    return {};
}

// Settings that depend on each other, and settings with a fixed list of values.
Status check_access(const Config& c) {
    if (c.tls.certificate.empty() != c.tls.key.empty())
        return invalid_argument("tls.certificate and tls.key belong together; set both or neither");
    if (!c.tls.client_ca.empty() && c.tls.certificate.empty())
        return invalid_argument("tls.client_ca is set without tls.certificate and tls.key");
    if (!c.auth.keys.empty() && (c.auth.issuer.empty() || c.auth.audience.empty()))
        return invalid_argument(
            "auth.keys is set without auth.issuer and auth.audience; set both to the expected "
            "claims");
    static constexpr std::array roles = {"", "none", "viewer", "player", "director", "admin"};
    if (std::find(roles.begin(), roles.end(), c.auth.anonymous_role) == roles.end())
        return invalid_argument("auth.anonymous_role is \"" + c.auth.anonymous_role +
                                "\"; it must be none, viewer, player, director or admin");
    for (const std::string& host : c.allowed_hosts)
        if (host.empty() || host.find_first_of("/ ") != std::string::npos)
            return invalid_argument(
                "allowed_hosts: \"" + host +
                "\" is not a host name; write only the name, such as play.example.org");
    return {};
}

// Either both are 0, or none is; the ranges of jostle/snapshot/precision.h.
Status check_precision(const StreamSettings& s) {
    if (s.position_precision_m == 0 && s.rotation_precision_rad == 0) return {};
    if (s.position_precision_m < 1e-4)
        return invalid_argument("stream.position_precision_m is " + text(s.position_precision_m) +
                                "; it must be 0 together with stream.rotation_precision_rad, or "
                                "from 0.0001 to 1");
    if (s.rotation_precision_rad < 2e-4)
        return invalid_argument("stream.rotation_precision_rad is " +
                                text(s.rotation_precision_rad) +
                                "; it must be 0 together with stream.position_precision_m, or "
                                "from 0.0002 to 0.5");
    return {};
}

}  // namespace

Status check(const Config& c) {
    const Range ranges[] = {
        {"drain_timeout_seconds", c.drain_timeout_seconds, 0, 3600},
        {"network_threads", c.network_threads, 1, 64},
        {"client.messages_per_second", c.client.messages_per_second, 1, 1e6},
        {"client.bytes_per_second", c.client.bytes_per_second, 1024, 1e9},
        {"client.inputs_per_second", c.client.inputs_per_second, 1, 1e6},
        {"client.message_bytes_max", c.client.message_bytes_max, 1024, 1 << 24},
        {"client.inputs_per_batch_max", c.client.inputs_per_batch_max, 1, 4096},
        {"client.user_messages_per_second", c.client.user_messages_per_second, 0.01, 1e6},
        {"client.user_message_bytes_max", c.client.user_message_bytes_max, 16, 65536},
        {"client.attribute_changes_per_second", c.client.attribute_changes_per_second, 1, 1e6},
        {"client.attribute_bytes_max", c.client.attribute_bytes_max, 0, 1 << 21},
        {"client.bodies_owned_max", c.client.bodies_owned_max, 0, 100000},
        {"client.joints_owned_max", c.client.joints_owned_max, 0, 100000},
        {"client.account_bodies_max", c.client.account_bodies_max, 0, 1000000},
        {"client.retained_bodies_seconds", c.client.retained_bodies_seconds, 0, 1e9},
        {"client.resume_timeout_seconds", c.client.resume_timeout_seconds, 0, 600},
        {"limits.idle_kick_seconds", c.limits.idle_kick_seconds, 0, 86400},
        {"limits.sessions_per_subject", c.limits.sessions_per_subject, 0, 100000},
        {"world.worlds_max", c.world.worlds_max, 1, 10000},
        {"world.bodies_max", c.world.bodies_max, 1, 1000000},
        {"world.bodies_total_max", c.world.bodies_total_max, 1, 100000000},
        {"world.clients_max", c.world.clients_max, 1, 100000},
        {"world.clients_per_address_max", c.world.clients_per_address_max, 1, 100000},
        {"world.spawn_load_max", c.world.spawn_load_max, 0, 100},
        {"world.command_queue_max", c.world.command_queue_max, 16, 1 << 20},
        {"world.attributes_per_target_max", c.world.attributes_per_target_max, 0, 1000},
        {"world.attribute_text_bytes_max", c.world.attribute_text_bytes_max, 0, 4096},
        {"world.attribute_bytes_max", c.world.attribute_bytes_max, 0, 1 << 21},
        {"world.user_message_bytes_per_second", c.world.user_message_bytes_per_second, 0, 1e9},
        {"connection.total_max", c.connection.total_max, 8, 1 << 20},
        {"connection.per_address_max", c.connection.per_address_max, 1, 1 << 20},
        {"connection.buffered_bytes_max", c.connection.buffered_bytes_max, 65536, 1e10},
        {"connection.buffered_total_bytes_max", c.connection.buffered_total_bytes_max, 65536, 1e11},
        {"connection.idle_timeout_seconds", c.connection.idle_timeout_seconds, 1, 86400},
        {"scene.request_bytes_max", c.scene.request_bytes_max, 1 << 22, 1 << 27},
        {"scene.joints_max", c.scene.joints_max, 0, 10000000},
        {"scene.joints_per_pair_max", c.scene.joints_per_pair_max, 1, 10000000},
        {"scene.geometry_bytes_max", c.scene.geometry_bytes_max, 1024, 1e10},
        {"scene.body_geometry_bytes_max", c.scene.body_geometry_bytes_max, 1024, 1 << 20},
        {"scene.work_per_second_max", c.scene.work_per_second_max, 1000, 1e12},
        {"scene.pairs_per_shape_max", c.scene.pairs_per_shape_max, 0, 1000000},
        {"scene.work_total_per_second_max", c.scene.work_total_per_second_max, 1000, 1e13},
        {"scene.first_step_seconds_max", c.scene.first_step_seconds_max, 0.01, 3600},
        {"tick.input_share", c.tick.input_share, 0, 1},
        {"tick.input_wait_seconds_max", c.tick.input_wait_seconds_max, 0, 60},
        {"tick.query_copy_share", c.tick.query_copy_share, 0, 1},
        {"tick.catch_up_ticks_max", c.tick.catch_up_ticks_max, 1, 100},
        {"tick.threads", c.tick.threads, 0, 1024},
        {"tick.physics_threads", c.tick.physics_threads, 1, 64},
        {"tick.step_seconds_max", c.tick.step_seconds_max, 0.05, 3600},
        {"tick.lag_compensation_ms_max", c.tick.lag_compensation_ms_max, 0, 2000},
        {"stream.ack_window_max_ms", c.stream.ack_window_max_ms, 200, 60000},
        {"stream.ack_interval_ms", c.stream.ack_interval_ms, 1, 1000},
        {"stream.interest_cell_m", c.stream.interest_cell_m, 1, 100000},
        {"stream.position_precision_m", c.stream.position_precision_m, 0, 1},
        {"stream.rotation_precision_rad", c.stream.rotation_precision_rad, 0, 0.5},
        {"stream.far_precision_factor", c.stream.far_precision_factor, 1, 1000},
        {"stream.heartbeats_per_second", c.stream.heartbeats_per_second, 0.5, 1000},
        {"stream.hello_timeout_seconds", c.stream.hello_timeout_seconds, 0.1, 3600},
        {"stream.client_timeout_seconds", c.stream.client_timeout_seconds, 0.5, 86400},
        {"stream.stats_per_second", c.stream.stats_per_second, 0.1, 60},
        {"stream.codec", c.stream.codec, 1, 2},
        {"persistence.checkpoint_interval_seconds", c.persistence.checkpoint_interval_seconds, 1,
         86400},
        {"persistence.replay_seconds_max", c.persistence.replay_seconds_max, 0.01, 3600},
        {"persistence.history_retention_hours", c.persistence.history_retention_hours, 0, 87600},
        {"datagrams.advertised_port", c.datagrams.advertised_port, 0, 65535},
        {"auth.leeway_seconds", c.auth.leeway_seconds, 0, 300},
        {"quota.creates_per_minute", c.quota.creates_per_minute, 1, 1e6},
        {"quota.joins_per_minute", c.quota.joins_per_minute, 1, 1e6},
        {"quota.queries_per_second", c.quota.queries_per_second, 1, 1e6},
        {"quota.query_share", c.quota.query_share, 0, 64},
        {"quota.address_factor", c.quota.address_factor, 1, 1e6},
        {"quota.refused_logins_per_minute", c.quota.refused_logins_per_minute, 1, 1e6},
        {"quota.refusals_audited_per_minute", c.quota.refusals_audited_per_minute, 1, 1e6},
        {"quota.buckets_max", c.quota.buckets_max, 100, 10'000'000},
    };
    for (const Range& r : ranges)
        if (!(r.low <= r.value && r.value <= r.high))
            return invalid_argument(std::string(r.key) + " is " + text(r.value) +
                                    "; it must be from " + text(r.low) + " to " + text(r.high));
    if (Status s = check_precision(c.stream); !s.ok()) return s;
    for (const auto& [key, address] : {std::pair("listen", c.listen), std::pair("http", c.http)})
        if (const auto parsed = parse_host_port(address); !parsed.ok())
            return invalid_argument(std::string(key) + ": " + parsed.error().message);
    for (const auto& [key, address] :
         {std::pair("admin", c.admin), std::pair("datagrams.listen", c.datagrams.listen)})
        if (const auto parsed = parse_host_port(address); !address.empty() && !parsed.ok())
            return invalid_argument(std::string(key) + ": " + parsed.error().message);
    static constexpr std::array levels = {"trace", "debug", "info", "warn", "error"};
    if (std::find(levels.begin(), levels.end(), c.log_level) == levels.end())
        return invalid_argument("log_level is \"" + c.log_level +
                                "\"; it must be trace, debug, info, warn or error");
    if (c.log_format != "text" && c.log_format != "json")
        return invalid_argument("log_format is \"" + c.log_format + "\"; it must be text or json");
    if (c.scenes.empty()) return invalid_argument("scenes is empty; name at least one scene");
    if (static_cast<int>(c.scenes.size()) > c.world.worlds_max)
        return invalid_argument("scenes lists more worlds than world.worlds_max allows");
    static constexpr std::array durability_levels = {"none", "process", "machine"};
    if (std::find(durability_levels.begin(), durability_levels.end(), c.persistence.durability) ==
        durability_levels.end())
        return invalid_argument("persistence.durability is \"" + c.persistence.durability +
                                "\"; it must be none, process or machine");
    if (const auto conditions = parse_network_conditions(c.development.network_conditions);
        !conditions.ok())
        return invalid_argument("development.network_conditions: " + conditions.error().message);
    if (Status s = check_proxies(c); !s.ok()) return s;
    return check_access(c);
}

Result<HostPort> parse_host_port(const std::string& address) {
    const auto bad = [&](const char* why) {
        return invalid_argument("\"" + address + "\" is not HOST:PORT: " + why);
    };
    const std::size_t colon = address.rfind(':');
    if (colon == std::string::npos) return bad("the colon is missing");
    HostPort out{.host = address.substr(0, colon)};
    if (out.host.size() > 2 && out.host.front() == '[' && out.host.back() == ']')
        out.host = out.host.substr(1, out.host.size() - 2);
    else if (out.host.find(':') != std::string::npos)
        return bad("write an IPv6 address as [ADDRESS]:PORT");
    if (out.host.empty()) return bad("the host is missing; use 0.0.0.0 for all addresses");
    const char* first = address.data() + colon + 1;
    const char* last = address.data() + address.size();
    const auto [end, error] = std::from_chars(first, last, out.port);
    if (first == last || error != std::errc{} || end != last)
        return bad("the port must be a number from 0 to 65535");
    return out;
}

}  // namespace jostle::server
