// SPDX-License-Identifier: MIT
//
// The analysis of rows, with synthetic rows.
#include "bench/accuracy/analysis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "bench/accuracy/accuracy_report.h"
#include "bench/accuracy/experiment_list.h"

namespace {

using namespace jostle::bench::accuracy;

Row row_of(const char* scene, const char* engine, double rate_hz, double error, double cost) {
    return {.scene = scene,
            .engine = engine,
            .mode = "m",
            .rate_hz = rate_hz,
            .error = error,
            .cpu_us_per_second = cost};
}

const std::vector<Row>& synthetic_rows() {
    static const std::vector<Row> rows = [] {
        std::vector<Row> all = {
            row_of("j1", "jostle", 30, 0.02, 50),     row_of("j1", "jostle", 60, 0.005, 100),
            row_of("j1", "jostle", 120, 0.0009, 200), row_of("j1", "peer", 30, 0.008, 40),
            row_of("j1", "peer", 60, 0.004, 90),      row_of("j1", "other", 60, 1e-6, 400),
        };
        all.push_back(row_of("j1", "other", 30, 1e-9, 1));
        all.back().failed = "a body is lost";
        return all;
    }();
    return rows;
}

TEST(Orders, are_computed_from_adjacent_rates) {
    const auto orders = observed_orders(synthetic_rows(), "j1", "jostle", "m");
    ASSERT_EQ(orders.size(), 2u);
    EXPECT_NEAR(orders[0].order, 2, 1e-12);
    EXPECT_EQ(orders[0].to_hz, 60);
    EXPECT_NEAR(orders[1].order, std::log2(0.005 / 0.0009), 1e-12);
    EXPECT_TRUE(observed_orders(synthetic_rows(), "j1", "other", "m").empty());
}

TEST(LeastWork, is_the_cheapest_row_within_tolerance) {
    EXPECT_EQ(least_work(synthetic_rows(), "j1", "jostle", 0.01)->cpu_us_per_second, 100);
    EXPECT_EQ(least_work(synthetic_rows(), "j1", "peer", 0.01)->cpu_us_per_second, 40);
    EXPECT_FALSE(least_work(synthetic_rows(), "j1", "peer", 0.001));
    EXPECT_EQ(least_work(synthetic_rows(), "j1", "other", 1)->cpu_us_per_second,
              400);  // the failed row does not count
}

TEST(ParetoSet, contains_rows_not_dominated_in_time_and_error) {
    const auto front = pareto_set(synthetic_rows(), "j1");
    ASSERT_EQ(front.size(), 4u);
    EXPECT_EQ(front[0].cpu_us_per_second, 40);
    EXPECT_EQ(front[1].cpu_us_per_second, 90);
    EXPECT_EQ(front[2].cpu_us_per_second, 200);
    EXPECT_EQ(front[3].error, 1e-6);
}

// The tolerances of j1 are 0.01, 0.001 and 1e-5: ratios of 40/100, 400/200, and one tolerance that
// only a peer reaches.
TEST(Score, is_the_geometric_mean_and_a_missing_result_counts_0_01) {
    const Score score = score_of(synthetic_rows(), "jostle");
    ASSERT_EQ(score.comparisons.size(), 3u);
    EXPECT_DOUBLE_EQ(score.comparisons[0].ratio, 0.4);
    EXPECT_DOUBLE_EQ(score.comparisons[1].ratio, 2);
    EXPECT_DOUBLE_EQ(score.comparisons[2].ratio, 0.01);
    EXPECT_NEAR(score.mean, std::cbrt(0.4 * 2 * 0.01), 1e-12);
    EXPECT_EQ(score.both_count, 2);
    EXPECT_NEAR(score.both_mean, std::sqrt(0.4 * 2), 1e-12);
    EXPECT_TRUE(score_of(synthetic_rows(), "jostle", Scope::families).comparisons.empty());
    const std::string text = score_report(score);
    EXPECT_NE(text.find("Behind in 2, below 1/2 in 2"), std::string::npos);
}

TEST(Score, skips_scenes_without_a_peer) {
    const std::vector<Row> alone = {row_of("j1", "jostle", 60, 0.005, 100)};
    EXPECT_TRUE(score_of(alone, "jostle").comparisons.empty());
}

TEST(Score, result_without_a_peer_match_counts_100) {
    const std::vector<Row> rows = {row_of("j1", "jostle", 60, 1e-6, 100),
                                   row_of("j1", "peer", 60, 1, 10)};
    const Score score = score_of(rows, "jostle");
    ASSERT_EQ(score.comparisons.size(), 3u);
    EXPECT_DOUBLE_EQ(score.mean, 100);
}

TEST(Report, prints_errors_orders_work_and_failure_reasons) {
    std::vector<Row> rows = synthetic_rows();
    rows.push_back(
        {.scene = "j1", .engine = "flat", .mode = "m", .rate_hz = 60, .unsupported = "no z"});
    const std::string text = scene_report(*find_experiment("j1"), rows);
    EXPECT_NE(text.find("30-60: 2.00"), std::string::npos) << text;
    EXPECT_NE(text.find("jostle 100 (m@60)"), std::string::npos);
    EXPECT_NE(text.find("unsupported: no z"), std::string::npos);
}

TEST(Rows, round_trip_through_json) {
    for (const Row& row : synthetic_rows()) {
        EXPECT_EQ(to_json(row_from(to_json(row))), to_json(row));
        EXPECT_EQ(to_json(row).contains("error"), row.failed.empty());
    }
    EXPECT_EQ(csv_line(synthetic_rows()[0]), "j1,jostle,m,30,0.02,0,50");
    EXPECT_EQ(csv_line(synthetic_rows().back()), "j1,other,m,30,blown,,");
}

TEST(Rows, round_trip_through_csv) {
    std::string text = csv_heading() + "\n";
    for (const Row& row : synthetic_rows()) text += csv_line(row) + "\n";
    std::istringstream in(text);
    const std::vector<Row> read = rows_from_csv(in);
    ASSERT_EQ(read.size(), synthetic_rows().size());
    for (std::size_t k = 0; k < read.size(); k++)
        EXPECT_EQ(csv_line(read[k]), csv_line(synthetic_rows()[k]));
    std::istringstream wrong(csv_heading() + "\nj1,jostle\n"), other("scene;engine\n");
    EXPECT_THROW(rows_from_csv(wrong), std::runtime_error);
    EXPECT_THROW(rows_from_csv(other), std::runtime_error);
}

TEST(ScenesCsv, has_measures_and_tolerances) {
    EXPECT_EQ(scenes_csv({find_experiment("f1")}),
              "scene,family,description,error,second_error,tolerances\n"
              "f1,," +
                  find_experiment("f1")->about +
                  ",\"position error at the end, m\",none,0.1 0.01 1e-06\n");
}

TEST(DocTables, replace_the_text_between_their_markers) {
    const std::string path = testing::TempDir() + "doc_tables_test.md";
    std::ofstream(path) << "a\n<!-- begin score -->\nold\n<!-- end score -->\nb\n";
    EXPECT_TRUE(replace_section(path, "score", "new\n"));
    std::ifstream in(path);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}),
              "a\n<!-- begin score -->\nnew\n<!-- end score -->\nb\n");
    EXPECT_FALSE(replace_section(path, "other", "new\n"));
    EXPECT_FALSE(replace_section("/nowhere/a.md", "score", "new\n"));
}

TEST(DocTables, contain_the_measured_values) {
    Row row = row_of("j1", "jostle", 60, 0.0015, 294.4);
    row.mode = "sub8";
    EXPECT_NE(
        jostle_table({row}).find("| j1 | RMS position error, m; widest joint gap, m | 0.0015 | 0 | "
                                 "294 |"),
        std::string::npos)
        << jostle_table({row});
    EXPECT_NE(score_table(score_of(synthetic_rows(), "jostle")).find("| j1 | 0.01 | 0.4 | peer |"),
              std::string::npos);
    const nlohmann::ordered_json verdicts = {{{"id", "s1"},
                                              {"engine", "jostle"},
                                              {"mode", "sub8"},
                                              {"pass", true},
                                              {"figure", 0.0035},
                                              {"limit", 0.1}},
                                             {{"id", "s1"},
                                              {"engine", "bullet"},
                                              {"mode", "si10"},
                                              {"pass", false},
                                              {"figure", 0.11},
                                              {"limit", 0.1}},
                                             {{"id", "s1"},
                                              {"engine", "ode"},
                                              {"mode", "quick20"},
                                              {"pass", false},
                                              {"why", "9 m/s"},
                                              {"figure", 0.05},
                                              {"limit", 0.1}},
                                             {{"id", "s1"},
                                              {"engine", "mujoco"},
                                              {"mode", "newton-euler"},
                                              {"pass", false},
                                              {"why", "a body is lost"},
                                              {"limit", 0.1}}};
    EXPECT_NE(stability_table(verdicts).find(
                  "| s1 | 0.1 | 0.0035 | **0.11** | **0.05 *** | **lost** | - |"),
              std::string::npos)
        << stability_table(verdicts);
}

}  // namespace
