// SPDX-License-Identifier: MIT
#include "server/config/config_loader.h"

#include <toml++/toml.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>
#include <vector>

#include "jostle/base/nearest_name.h"

namespace jostle::server {

namespace {

// Sets one field from a value; returns false if the value has the wrong type.
using Setter = std::function<bool(const toml::node&)>;

template <class T>
Setter into(T& field) {
    return [&field](const toml::node& node) {
        if constexpr (std::is_same_v<T, std::vector<std::string>>) {
            const toml::array* array = node.as_array();
            if (!array) return false;
            std::vector<std::string> items;
            for (const toml::node& item : *array) {
                const auto text = item.value<std::string>();
                if (!text || !item.is_string()) return false;
                items.push_back(*text);
            }
            field = std::move(items);
            return true;
        } else if constexpr (std::is_same_v<T, int>) {
            if (!node.is_integer()) return false;
            const std::int64_t value = *node.value<std::int64_t>();
            if (value < -2147483647 || value > 2147483647) return false;
            field = static_cast<int>(value);
            return true;
        } else if constexpr (std::is_same_v<T, double>) {
            if (!node.is_number()) return false;
            field = *node.value<double>();
            return true;
        } else if constexpr (std::is_same_v<T, bool>) {
            if (!node.is_boolean()) return false;
            field = *node.value<bool>();
            return true;
        } else {
            if (!node.is_string()) return false;
            field = *node.value<std::string>();
            return true;
        }
    };
}

using Setters = std::map<std::string, Setter, std::less<>>;

Setters setters_of(Config& c) {
    return {
        {"listen", into(c.listen)},
        {"http", into(c.http)},
        {"admin", into(c.admin)},
        {"web_root", into(c.web_root)},
        {"scenes", into(c.scenes)},
        {"allowed_origins", into(c.allowed_origins)},
        {"allowed_hosts", into(c.allowed_hosts)},
        {"trusted_proxies", into(c.trusted_proxies)},
        {"forwarded_header", into(c.forwarded_header)},
        {"proxy_protocol", into(c.proxy_protocol)},
        {"insecure", into(c.insecure)},
        {"log_level", into(c.log_level)},
        {"log_format", into(c.log_format)},
        {"advertised_host", into(c.advertised_host)},
        {"drain_timeout_seconds", into(c.drain_timeout_seconds)},
        {"network_threads", into(c.network_threads)},
        {"client.messages_per_second", into(c.client.messages_per_second)},
        {"client.bytes_per_second", into(c.client.bytes_per_second)},
        {"client.inputs_per_second", into(c.client.inputs_per_second)},
        {"client.message_bytes_max", into(c.client.message_bytes_max)},
        {"client.inputs_per_batch_max", into(c.client.inputs_per_batch_max)},
        {"client.user_messages_per_second", into(c.client.user_messages_per_second)},
        {"client.user_message_bytes_max", into(c.client.user_message_bytes_max)},
        {"client.attribute_changes_per_second", into(c.client.attribute_changes_per_second)},
        {"client.attribute_bytes_max", into(c.client.attribute_bytes_max)},
        {"client.bodies_owned_max", into(c.client.bodies_owned_max)},
        {"client.joints_owned_max", into(c.client.joints_owned_max)},
        {"client.account_bodies_max", into(c.client.account_bodies_max)},
        {"client.retained_bodies_seconds", into(c.client.retained_bodies_seconds)},
        {"client.retain_bodies_after_leave", into(c.client.retain_bodies_after_leave)},
        {"client.resume_timeout_seconds", into(c.client.resume_timeout_seconds)},
        {"limits.idle_kick_seconds", into(c.limits.idle_kick_seconds)},
        {"limits.sessions_per_subject", into(c.limits.sessions_per_subject)},
        {"development.network_conditions", into(c.development.network_conditions)},
        {"development.network_conditions_worlds", into(c.development.network_conditions_worlds)},
        {"connection.total_max", into(c.connection.total_max)},
        {"connection.per_address_max", into(c.connection.per_address_max)},
        {"connection.buffered_bytes_max", into(c.connection.buffered_bytes_max)},
        {"connection.buffered_total_bytes_max", into(c.connection.buffered_total_bytes_max)},
        {"connection.idle_timeout_seconds", into(c.connection.idle_timeout_seconds)},
        {"scene.joints_max", into(c.scene.joints_max)},
        {"scene.joints_per_pair_max", into(c.scene.joints_per_pair_max)},
        {"scene.request_bytes_max", into(c.scene.request_bytes_max)},
        {"scene.geometry_bytes_max", into(c.scene.geometry_bytes_max)},
        {"scene.body_geometry_bytes_max", into(c.scene.body_geometry_bytes_max)},
        {"scene.work_per_second_max", into(c.scene.work_per_second_max)},
        {"scene.pairs_per_shape_max", into(c.scene.pairs_per_shape_max)},
        {"scene.work_total_per_second_max", into(c.scene.work_total_per_second_max)},
        {"scene.first_step_seconds_max", into(c.scene.first_step_seconds_max)},
        {"world.worlds_max", into(c.world.worlds_max)},
        {"world.bodies_max", into(c.world.bodies_max)},
        {"world.bodies_total_max", into(c.world.bodies_total_max)},
        {"world.clients_max", into(c.world.clients_max)},
        {"world.clients_per_address_max", into(c.world.clients_per_address_max)},
        {"world.spawn_load_max", into(c.world.spawn_load_max)},
        {"world.command_queue_max", into(c.world.command_queue_max)},
        {"world.attributes_per_target_max", into(c.world.attributes_per_target_max)},
        {"world.attribute_text_bytes_max", into(c.world.attribute_text_bytes_max)},
        {"world.attribute_bytes_max", into(c.world.attribute_bytes_max)},
        {"world.user_message_bytes_per_second", into(c.world.user_message_bytes_per_second)},
        {"tick.catch_up_ticks_max", into(c.tick.catch_up_ticks_max)},
        {"tick.threads", into(c.tick.threads)},
        {"tick.physics_threads", into(c.tick.physics_threads)},
        {"tick.input_share", into(c.tick.input_share)},
        {"tick.input_wait_seconds_max", into(c.tick.input_wait_seconds_max)},
        {"tick.query_copy_share", into(c.tick.query_copy_share)},
        {"tick.step_seconds_max", into(c.tick.step_seconds_max)},
        {"tick.lag_compensation_ms_max", into(c.tick.lag_compensation_ms_max)},
        {"stream.ack_window_max_ms", into(c.stream.ack_window_max_ms)},
        {"stream.ack_interval_ms", into(c.stream.ack_interval_ms)},
        {"stream.interest_cell_m", into(c.stream.interest_cell_m)},
        {"stream.position_precision_m", into(c.stream.position_precision_m)},
        {"stream.rotation_precision_rad", into(c.stream.rotation_precision_rad)},
        {"stream.far_precision_factor", into(c.stream.far_precision_factor)},
        {"stream.heartbeats_per_second", into(c.stream.heartbeats_per_second)},
        {"stream.hello_timeout_seconds", into(c.stream.hello_timeout_seconds)},
        {"stream.client_timeout_seconds", into(c.stream.client_timeout_seconds)},
        {"stream.stats_per_second", into(c.stream.stats_per_second)},
        {"stream.codec", into(c.stream.codec)},
        {"persistence.database", into(c.persistence.database)},
        {"persistence.durability", into(c.persistence.durability)},
        {"persistence.checkpoint_interval_seconds",
         into(c.persistence.checkpoint_interval_seconds)},
        {"persistence.replay_seconds_max", into(c.persistence.replay_seconds_max)},
        {"persistence.history_retention_hours", into(c.persistence.history_retention_hours)},
        {"datagrams.listen", into(c.datagrams.listen)},
        {"datagrams.advertised_port", into(c.datagrams.advertised_port)},
        {"tls.certificate", into(c.tls.certificate)},
        {"tls.key", into(c.tls.key)},
        {"tls.client_ca", into(c.tls.client_ca)},
        {"auth.issuer", into(c.auth.issuer)},
        {"auth.audience", into(c.auth.audience)},
        {"auth.keys", into(c.auth.keys)},
        {"auth.anonymous_role", into(c.auth.anonymous_role)},
        {"auth.leeway_seconds", into(c.auth.leeway_seconds)},
        {"auth.audit_log", into(c.auth.audit_log)},
        {"quota.creates_per_minute", into(c.quota.creates_per_minute)},
        {"quota.joins_per_minute", into(c.quota.joins_per_minute)},
        {"quota.queries_per_second", into(c.quota.queries_per_second)},
        {"quota.query_share", into(c.quota.query_share)},
        {"quota.address_factor", into(c.quota.address_factor)},
        {"quota.refused_logins_per_minute", into(c.quota.refused_logins_per_minute)},
        {"quota.refusals_audited_per_minute", into(c.quota.refusals_audited_per_minute)},
        {"quota.buckets_max", into(c.quota.buckets_max)},
    };
}

std::string location_of(const std::string& name, const toml::source_region& source) {
    return name + ":" + std::to_string(source.begin.line) + ": ";
}

Status apply_table(const Setters& setters, const toml::table& table, const std::string& prefix,
                   const std::string& name) {
    std::vector<std::string> names, sections;
    for (const auto& [setting, ignored] : setters) {
        names.push_back(setting);
        if (const std::size_t dot = setting.find('.'); dot != std::string::npos)
            sections.push_back(setting.substr(0, dot));
    }
    for (const auto& [key, node] : table) {
        const std::string path = prefix + std::string(key.str());
        if (const toml::table* inner = node.as_table(); inner && prefix.empty()) {
            if (std::find(sections.begin(), sections.end(), path) == sections.end())
                return Error{ErrorCode::invalid_argument,
                             location_of(name, inner->source()) + "unknown section [" + path + "]" +
                                 did_you_mean(path, sections) +
                                 "; docs/reference/configuration.md lists the sections"};
            if (Status s = apply_table(setters, *inner, path + ".", name); !s.ok()) return s;
            continue;
        }
        const auto at = setters.find(path);
        if (at == setters.end())
            return Error{ErrorCode::invalid_argument,
                         location_of(name, node.source()) + "unknown setting \"" + path + "\"" +
                             did_you_mean(path, names) +
                             "; docs/reference/configuration.md lists the settings"};
        if (!at->second(node))
            return Error{ErrorCode::invalid_argument, location_of(name, node.source()) + "\"" +
                                                          path +
                                                          "\" has a value of the wrong type"};
    }
    return {};
}

}  // namespace

Status load_config_text(Config& config, const std::string& text, const std::string& name) {
    toml::table table;
    try {
        table = toml::parse(text, name);
    } catch (const toml::parse_error& error) {
        return Error{ErrorCode::invalid_argument,
                     location_of(name, error.source()) + std::string(error.description())};
    }
    Config changed = config;
    if (Status s = apply_table(setters_of(changed), table, "", name); !s.ok()) return s;
    if (Status s = check(changed); !s.ok())
        return Error{ErrorCode::invalid_argument, name + ": " + s.error().message};
    config = changed;
    return {};
}

Status load_settings(Config& config, const std::vector<std::string>& settings) {
    std::string lines;
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos || setting.find('\n') != std::string::npos)
            return Error{
                ErrorCode::invalid_argument,
                "\"" + setting + "\" is not KEY=VALUE; write it as in client.bodies_owned_max=10"};
        const std::string key = setting.substr(0, equals), value = setting.substr(equals + 1);
        try {
            static_cast<void>(toml::parse(setting));
            lines += setting + "\n";
        } catch (const toml::parse_error&) {
            std::ostringstream text;
            text << toml::value<std::string>(value);
            lines += key + " = " + text.str() + "\n";
        }
    }
    return load_config_text(config, lines, "--set");
}

Status load_config(Config& config, const std::string& path) {
    std::error_code ignored;  // a path without access cannot be opened either
    std::ifstream in(path);
    // A directory opens, but reading from it throws.
    if (!in || std::filesystem::is_directory(path, ignored))
        return Error{ErrorCode::not_found, "cannot read the config file " + path};
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    return load_config_text(config, text, path);
}

}  // namespace jostle::server
