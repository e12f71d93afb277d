// SPDX-License-Identifier: MIT
#include "load/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace jostle::load {

TEST(Report, percentiles_of_a_hundred_and_one_ages) {
    std::vector<float> ages;
    for (int i = 100; i >= 0; i--) ages.push_back(static_cast<float>(i));
    EXPECT_EQ(percentile(ages, 50), 50);
    EXPECT_EQ(percentile(ages, 99), 99);
    std::vector<float> none;
    EXPECT_EQ(percentile(none, 99), 0);
}

TEST(Report, a_missed_plan_says_what_was_missed) {
    const Report report{.clients = 10,
                        .connected = 9,
                        .snapshots = 5,
                        .age_ms_p99 = 60,
                        .ages_measured = 5,
                        .errors = 2,
                        .last_error = "gone"};
    EXPECT_EQ(missed(report, {.age_ms_p99_max = 50.0, .errors_max = 0, .connected_min = {}}).size(),
              3u);
    EXPECT_TRUE(
        missed(report, {.age_ms_p99_max = {}, .errors_max = 2, .connected_min = 9}).empty());
    // No clock, no age: a plan for the age is not kept by knowing nothing.
    const Report blind{.clients = 1, .connected = 1, .snapshots = 5, .last_error = {}};
    EXPECT_EQ(missed(blind, {.age_ms_p99_max = 50.0, .errors_max = 0, .connected_min = {}}).size(),
              1u);
}

TEST(Report, json_has_every_promised_key_and_null_for_what_is_not_known) {
    const auto json =
        nlohmann::json::parse(to_json({.clients = 3, .server_cpu_percent = {}, .last_error = {}}));
    for (const char* key : {"clients", "connected", "inputs_sent", "inputs_accepted", "snapshots",
                            "kbit_per_second_per_client", "snapshots_per_second_per_client",
                            "age_ms_p50", "age_ms_p99", "errors", "server_cpu_percent"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_TRUE(json["server_cpu_percent"].is_null());
}

}  // namespace jostle::load
