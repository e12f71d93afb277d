// SPDX-License-Identifier: MIT
//
// The rules for the rows of Jostle, with synthetic rows.
#include "bench/accuracy/faults.h"

#include <gtest/gtest.h>

#include <sstream>

namespace {

using namespace jostle::bench::accuracy;

// The finest tolerance is 0.001, so errors below 1e-4 are not compared.
Experiment scene_with_limits() {
    return {.name = "x",
            .tolerances = {0.1, 0.001},
            .limit = 0.02,
            .second_limit = 0.5,
            .limit_from_hz = 60};
}

Row row_at(double rate_hz, double error, double second = 0, const char* mode = "sub8") {
    return {.scene = "x",
            .engine = "jostle",
            .mode = mode,
            .rate_hz = rate_hz,
            .error = error,
            .second_error = second};
}

std::vector<Fault> faults_in(const std::vector<Row>& rows) {
    static const Experiment scene = scene_with_limits();
    return faults_of(rows, {&scene});
}

TEST(Faults, finer_rate_must_not_be_worse_by_more_than_a_third) {
    EXPECT_TRUE(faults_in({row_at(30, 0.003), row_at(60, 0.0039), row_at(120, 0.0035)}).empty());
    const auto faults = faults_in({row_at(30, 0.003), row_at(60, 0.0041), row_at(120, 0.0045)});
    ASSERT_EQ(faults.size(), 1u) << "the worst of a scene and mode";
    EXPECT_EQ(faults[0].rule, "finer");
    EXPECT_NEAR(faults[0].ratio, 1.5, 1e-12);
    EXPECT_EQ(faults[0].words, "error 0.0045 at 120 Hz, 0.003 at 30 Hz");
}

TEST(Faults, compare_with_the_best_coarser_rate) {
    const auto faults = faults_in({row_at(120, 0.006), row_at(30, 0.008), row_at(60, 0.004)});
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_NEAR(faults[0].ratio, 1.5, 1e-12);
}

TEST(Faults, errors_below_the_floor_are_not_compared) {
    EXPECT_TRUE(faults_in({row_at(30, 1e-6), row_at(60, 1.3e-4)}).empty());
    EXPECT_EQ(faults_in({row_at(30, 1e-6), row_at(60, 1.4e-4)}).size(), 1u);
}

TEST(Faults, modes_are_separate) {
    EXPECT_TRUE(faults_in({row_at(30, 0.003), row_at(60, 0.009, 0, "iterative")}).empty());
    const auto faults =
        faults_in({row_at(30, 0.003, 0, "iterative"), row_at(60, 0.1, 0, "iterative")});
    EXPECT_TRUE(
        faults_in({row_at(30, 0.003, 0, "tol1e-2"), row_at(60, 0.009, 0, "tol1e-2")}).empty());
    ASSERT_EQ(faults.size(), 1u) << "limits hold in the default mode";
    EXPECT_EQ(faults[0].mode, "iterative");
}

TEST(Faults, failed_run_is_worse_than_any_error) {
    Row failed = row_at(60, 0);
    failed.failed = "a body is lost";
    const auto faults = faults_in({row_at(30, 0.003), failed});
    ASSERT_EQ(faults.size(), 3u);
    EXPECT_EQ(faults[0].words, "a body is lost at 60 Hz, but not at 30 Hz");
    EXPECT_EQ(faults_in({row_at(30, 0.003), row_at(120, 0.002)}).size(), 0u);
}

TEST(Faults, errors_above_a_limit_count_from_its_rate) {
    EXPECT_TRUE(faults_in({row_at(30, 0.05, 1), row_at(60, 0.02, 0.5)}).empty());
    const auto faults = faults_in({row_at(60, 0.03, 1), row_at(120, 0.025, 2)});
    ASSERT_EQ(faults.size(), 2u);
    EXPECT_EQ(faults[0].rule, "limit");
    EXPECT_NEAR(faults[0].ratio, 1.5, 1e-12);
    EXPECT_EQ(faults[1].rule, "second limit");
    EXPECT_NEAR(faults[1].ratio, 4, 1e-12);
}

TEST(Faults, known_faults_are_explained_until_they_grow_by_a_third) {
    static const Experiment scene = scene_with_limits();
    std::istringstream file(
        R"({"rows": [{"scene": "x", "rule": "finer", "ratio": 2, "cause": "a corner"},
                     {"scene": "x", "rule": "limit", "ratio": 2, "cause": "another"},
                     {"scene": "y", "rule": "limit", "ratio": 2, "cause": "did not run"}]})");
    const std::vector<KnownFault> known = known_faults_from(file);
    ASSERT_EQ(known.size(), 3u);
    const auto judge_error = [&](double error) {
        return judge(faults_in({row_at(30, 0.003), row_at(60, error)}), known, {&scene});
    };
    const JudgedFaults explained = judge_error(0.0079);
    EXPECT_TRUE(explained.failures.empty());
    ASSERT_EQ(explained.explained.size(), 1u);
    ASSERT_EQ(explained.obsolete.size(), 1u);
    EXPECT_EQ(explained.obsolete[0].rule, "limit");
    EXPECT_NE(to_text(explained).find("known: x, finer: error 0.0079 at 60 Hz, 0.003 at 30 Hz"),
              std::string::npos);
    EXPECT_NE(to_text(explained).find("; a corner"), std::string::npos);
    EXPECT_NE(to_text(explained).find("obsolete: x, limit"), std::string::npos);
    const JudgedFaults grown = judge_error(0.0081);
    EXPECT_EQ(grown.failures.size(), 1u);
    EXPECT_NE(to_text(grown).find("FAULT: x, finer"), std::string::npos);
}

TEST(Faults, update_refreshes_ratios_and_removes_obsolete_faults) {
    static const Experiment scene = scene_with_limits();
    const std::vector<KnownFault> known = {{"x", "sub8", "finer", 9, "a"},
                                           {"x", "sub8", "limit", 9, "b"},
                                           {"y", "sub8", "limit", 9, "c"}};
    const auto after = updated(known, faults_in({row_at(30, 0.003), row_at(60, 0.006)}), {&scene});
    ASSERT_EQ(after.size(), 2u);
    EXPECT_NEAR(after[0].ratio, 2, 1e-12);
    EXPECT_EQ(after[0].cause, "a");
    EXPECT_EQ(after[1].scene, "y") << "did not run";
    EXPECT_EQ(to_json(after)[0].dump(), R"({"scene":"x","rule":"finer","ratio":2.0,"cause":"a"})");
}

}  // namespace
