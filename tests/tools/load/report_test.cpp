// SPDX-License-Identifier: MIT
#include "tools/load/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace jostle::load {

TEST(Report, lists_violated_thresholds) {
    const Report report{.clients = 10,
                        .connected = 9,
                        .snapshots = 5,
                        .age_ms = {.count = 5, .p99 = 60},
                        .errors = 2,
                        .last_error = "gone"};
    EXPECT_EQ(
        violated_thresholds(report, {.age_ms_p99_max = 50.0, .errors_max = 0, .connected_min = {}})
            .size(),
        3u);
    EXPECT_TRUE(
        violated_thresholds(report, {.age_ms_p99_max = {}, .errors_max = 2, .connected_min = 9})
            .empty());
    // Without a clock there is no age, and a threshold for the age is violated.
    const Report blind{.clients = 1, .connected = 1, .snapshots = 5, .last_error = {}};
    EXPECT_EQ(
        violated_thresholds(blind, {.age_ms_p99_max = 50.0, .errors_max = 0, .connected_min = {}})
            .size(),
        1u);
}

TEST(Report, writes_every_documented_json_key_and_null_for_unknown_values) {
    const auto json =
        nlohmann::json::parse(to_json({.clients = 3, .server_cpu_percent = {}, .last_error = {}}));
    for (const char* key : {"clients",
                            "connected",
                            "seconds",
                            "inputs_sent",
                            "inputs_accepted",
                            "snapshots",
                            "kbit_per_second_per_client",
                            "snapshots_per_second_per_client",
                            "snapshot_bytes",
                            "decoded_share",
                            "frozen_share",
                            "age_ms_p50",
                            "age_ms_p99",
                            "age_ms",
                            "gap_ms",
                            "result_delay_ms",
                            "effect_delay_ms",
                            "age_windows_ms",
                            "errors",
                            "server_cpu_percent"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_TRUE(json["server_cpu_percent"].is_null());
    EXPECT_TRUE(json["result_delay_ms"].is_null());
}

TEST(Report, computes_rates_per_client) {
    LoadMetrics metrics;
    metrics.seconds = 0.5;
    metrics.messages = metrics.snapshots = 60;
    metrics.bytes = 60'000;
    metrics.snapshot_bytes = 57'000;
    metrics.decoded = 6;
    metrics.cpu_seconds = 300e-6;
    const Report report = make_report(metrics, 2);
    EXPECT_DOUBLE_EQ(report.snapshots_per_second_per_client, 60);
    EXPECT_DOUBLE_EQ(report.kbit_per_second_per_client, 480);
    EXPECT_DOUBLE_EQ(report.snapshot_bytes, 950);
    EXPECT_DOUBLE_EQ(report.decoded_share, 0.1);
    EXPECT_NEAR(report.load_cpu_us, 5, 1e-9);
}

}  // namespace jostle::load
