// SPDX-License-Identifier: MIT
//
// The metrics as Prometheus reads them: series with fixed labels exist from the start, the series
// of a world exist as long as the world, and clients cannot create series.
#include "server/metrics/metrics.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <memory>
#include <regex>
#include <sstream>

#include "server/metrics/metrics_text.h"
#include "server/metrics/rpc_metrics.h"
#include "server/metrics/world_metrics.h"

namespace jostle::server {
namespace {

class MetricsTest : public testing::Test {
protected:
    // The value of a series as Prometheus reads it; -1: no such series.
    double value(const std::string& series) {
        std::istringstream lines(metrics_text(metrics));
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with(series + " ")) return std::stod(line.substr(series.size() + 1));
        return -1;
    }
    bool mentions(const std::string& text) {
        return metrics_text(metrics).find(text) != std::string::npos;
    }

    Metrics metrics{"1.2.3", {"update_pairs", "solve"}};
};

TEST_F(MetricsTest, series_with_fixed_labels_exist_from_the_start) {
    EXPECT_EQ(value("jostle_build_info{version=\"1.2.3\"}"), 1);
    for (const char* series :
         {"jostle_inputs_total{code=\"applied\"}", "jostle_inputs_total{code=\"limit\"}",
          "jostle_snapshots_skipped_total{reason=\"window\"}",
          "jostle_snapshots_skipped_total{reason=\"rate\"}",
          "jostle_refusals_total{reason=\"resource_exhausted\"}",
          "jostle_step_stage_seconds_total{stage=\"solve\"}",
          "jostle_connections{listener=\"admin\"}",
          "jostle_connections_refused_total{listener=\"http\",reason=\"limit\"}",
          "jostle_snapshots_sent_total", "jostle_snapshot_bytes_total", "jostle_log_dropped_total",
          "jostle_world_restarts_total"})
        EXPECT_EQ(value(series), 0) << series;
}

TEST_F(MetricsTest, counts_each_label_separately) {
    metrics.inputs[InputOutcome::limit].Increment(3);
    metrics.refusals[ErrorCode::unauthenticated].Increment();
    metrics.listener(Listener::http).open.Set(7);
    metrics.listener(Listener::http).refused(ConnectionRefusal::address_limit).Increment();
    EXPECT_EQ(value("jostle_inputs_total{code=\"limit\"}"), 3);
    EXPECT_EQ(value("jostle_inputs_total{code=\"applied\"}"), 0);
    EXPECT_EQ(value("jostle_refusals_total{reason=\"unauthenticated\"}"), 1);
    EXPECT_EQ(value("jostle_connections{listener=\"http\"}"), 7);
    EXPECT_EQ(value("jostle_connections_refused_total{listener=\"http\",reason=\"address_limit\"}"),
              1);
}

TEST_F(MetricsTest, raise_to_never_lowers_a_counter) {
    raise_to(metrics.log_dropped, 5);
    raise_to(metrics.log_dropped, 3);
    EXPECT_EQ(value("jostle_log_dropped_total"), 5);
}

TEST_F(MetricsTest, world_series_exist_while_held) {
    {
        WorldMetrics world(metrics, "arena \"one\"\n");
        const std::vector<double> stage_ms{0.5, 1.5};
        world.count_tick({.seconds = 0.003,
                          .lateness_seconds = 0.0015,
                          .stage_ms = stage_ms,
                          .bodies = 40,
                          .awake = 12,
                          .queued = 5,
                          .late_ticks = 2});
        world.count_tick({.seconds = 0.0001, .bodies = 41, .late_ticks = 3});
        world.clients().Increment();
        const std::string label = "{world=\"arena \\\"one\\\"\\n\"";
        EXPECT_EQ(value("jostle_world_bodies" + label + "}"), 41);
        EXPECT_EQ(value("jostle_world_awake_bodies" + label + "}"), 0);
        EXPECT_EQ(value("jostle_late_ticks_total" + label + "}"), 3);
        EXPECT_EQ(value("jostle_world_paused" + label + "}"), 1)
            << "the world did not step in the last tick";
        EXPECT_EQ(value("jostle_clients" + label + "}"), 1);
        EXPECT_EQ(value("jostle_tick_duration_seconds_count" + label + "}"), 2);
        EXPECT_EQ(value("jostle_tick_duration_seconds_bucket" + label + ",le=\"0.001\"}"), 1);
        EXPECT_NEAR(value("jostle_tick_duration_seconds_sum" + label + "}"), 0.0031, 1e-9);
        EXPECT_EQ(value("jostle_tick_lateness_seconds_bucket" + label + ",le=\"0.001\"}"), 1);
        EXPECT_EQ(value("jostle_tick_lateness_seconds_bucket" + label + ",le=\"0.002\"}"), 2);
        // The times of the step stages cover all worlds and remain when a world is removed.
        EXPECT_DOUBLE_EQ(value("jostle_step_stage_seconds_total{stage=\"solve\"}"), 0.0015);
    }
    EXPECT_FALSE(mentions("arena")) << "the series of a deleted world must be removed";
    EXPECT_DOUBLE_EQ(value("jostle_step_stage_seconds_total{stage=\"solve\"}"), 0.0015);
}

// A world is deleted and recreated under the same name while clients of the old world still hold
// it.
TEST_F(MetricsTest, reused_world_name_shares_series_until_last_release) {
    auto old_one = std::make_unique<WorldMetrics>(metrics, "arena");
    auto new_one = std::make_unique<WorldMetrics>(metrics, "arena");
    old_one.reset();
    new_one->count_tick({.seconds = 0.001, .bodies = 3});
    EXPECT_EQ(value("jostle_world_bodies{world=\"arena\"}"), 3);
    new_one.reset();
    EXPECT_FALSE(mentions("arena"));
}

TEST_F(MetricsTest, counts_calls_by_method_and_code_without_series_for_unknown_methods) {
    RpcMetrics rpcs(metrics);
    rpcs.add("/jostle.v1.WorldService/ListWorlds", RpcMetrics::Kind::unary);
    rpcs.add("/jostle.v1.PlayService/Play", RpcMetrics::Kind::streaming);
    const auto series = [](const char* service, const char* method, const char* code) {
        return std::string("grpc_server_handled_total{grpc_code=\"") + code + "\",grpc_method=\"" +
               method + "\",grpc_service=\"" + service + "\"}";
    };
    EXPECT_EQ(value(series("jostle.v1.PlayService", "Play", "OK")), 0)
        << "the series must exist from the start";
    rpcs.handled("/jostle.v1.WorldService/ListWorlds", 0, 0.002);
    rpcs.handled("/jostle.v1.WorldService/ListWorlds", 5, 0.002);
    rpcs.handled("/jostle.v1.PlayService/Play", 1, 3600);
    for (int i = 0; i < 100; i++) rpcs.handled("/evil/" + std::to_string(i), 12, 0.001);
    rpcs.handled("", 99, 0.001);
    EXPECT_EQ(value(series("jostle.v1.WorldService", "ListWorlds", "OK")), 1);
    EXPECT_EQ(value(series("jostle.v1.WorldService", "ListWorlds", "NOT_FOUND")), 1);
    EXPECT_EQ(value(series("jostle.v1.PlayService", "Play", "CANCELLED")), 1);
    EXPECT_EQ(value(series("unknown", "unknown", "UNIMPLEMENTED")), 100);
    EXPECT_EQ(value(series("unknown", "unknown", "UNKNOWN")), 1)
        << "an unknown status code counts as UNKNOWN";
    EXPECT_FALSE(mentions("evil"));
    EXPECT_EQ(value("grpc_server_handling_seconds_count{grpc_method=\"ListWorlds\",grpc_service="
                    "\"jostle.v1.WorldService\"}"),
              2);
    EXPECT_FALSE(mentions("grpc_server_handling_seconds_count{grpc_method=\"Play\""))
        << "streams have no duration metric";
}

TEST_F(MetricsTest, reports_current_process_metrics) {
    const double previous = value("process_open_fds");
    const int fds[] = {dup(0), dup(0), dup(0)};
    EXPECT_EQ(value("process_open_fds"), previous + 3);
    for (const int fd : fds) close(fd);
    EXPECT_GE(value("process_max_fds"), previous + 3);
    EXPECT_GT(value("process_resident_memory_bytes"), 1e6);
    EXPECT_GT(value("process_virtual_memory_bytes"), value("process_resident_memory_bytes"));
    EXPECT_NEAR(value("process_start_time_seconds"), static_cast<double>(time(nullptr)), 600);
    EXPECT_GE(value("process_cpu_seconds_total"), 0);
}

// The rules of promtool, which scripts/observe-check runs: base units, and the suffix _total for
// counters.
TEST_F(MetricsTest, names_and_help_follow_promtool_rules) {
    const WorldMetrics world(metrics, "arena");
    RpcMetrics rpcs(metrics);
    rpcs.add("/jostle.v1.WorldService/ListWorlds", RpcMetrics::Kind::unary);
    metrics.certificate_expiry.Add({{"listener", "http"}}).Set(2e9);
    metrics.cadence_clients.Add({{"divisor", "1"}}).Set(1);
    std::istringstream lines(metrics_text(metrics));
    const std::regex name("(jostle|grpc_server|process)_[a-z_]+");
    int families = 0;
    std::string help_of;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string hash, kind, family, type;
        words >> hash >> kind >> family >> type;
        if (hash != "#") continue;
        EXPECT_TRUE(std::regex_match(family, name)) << family;
        if (kind == "HELP") {
            help_of = family;
            EXPECT_GT(line.size(), 20 + family.size()) << "the help text is too short: " << line;
        } else {
            families++;
            EXPECT_EQ(help_of, family) << "every family must have a help text";
            EXPECT_EQ(type == "counter", family.ends_with("_total")) << family;
        }
    }
    EXPECT_EQ(families, 42) << "every family of the table must have a series";
}

}  // namespace
}  // namespace jostle::server
