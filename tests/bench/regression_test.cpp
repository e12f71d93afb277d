// SPDX-License-Identifier: MIT
//
// The regressions that the short accuracy run reports, with synthetic rows.
#include "bench/accuracy/regression.h"
#include "bench/accuracy/experiment_list.h"

#include <gtest/gtest.h>

namespace {

using namespace jostle::bench::accuracy;

Row short_row(const char* scene, double error, double second = 0, double rate_hz = 60) {
    return {.scene = scene, .rate_hz = rate_hz, .error = error, .second_error = second};
}

Row failed_row(const char* scene) {
    Row row = short_row(scene, 0);
    row.failed = "a body is lost";
    return row;
}

int faults_in(const std::vector<RegressionChange>& changes) {
    int faults = 0;
    for (const RegressionChange& change : changes) faults += change.fault;
    return faults;
}

TEST(Regression, result_worse_by_more_than_a_third_fails_with_both_values) {
    const auto changes = changes_between({short_row("j1", 0.001)}, {short_row("j1", 0.002)}, true);
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_TRUE(changes[0].fault);
    EXPECT_EQ(changes[0].scene, "j1");
    EXPECT_EQ(changes[0].rate_hz, 60);
    EXPECT_EQ(changes[0].words, "error 0.001 -> 0.002 (2.00 times)");
}

TEST(Regression, changes_within_a_third_are_not_reported) {
    EXPECT_TRUE(
        changes_between({short_row("j1", 3, 3)}, {short_row("j1", 3.9, 2.4)}, true).empty());
}

TEST(Regression, improvements_are_reported_without_failing) {
    const auto changes = changes_between({short_row("j1", 0.01)}, {short_row("j1", 0.001)}, true);
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_FALSE(changes[0].fault);
}

TEST(Regression, rounding_differences_do_not_fail) {
    EXPECT_TRUE(changes_between({short_row("f1", 2e-14)}, {short_row("f1", 9e-13)}, true).empty());
    EXPECT_EQ(faults_in(changes_between({short_row("f1", 2e-14)}, {short_row("f1", 1e-6)}, true)),
              1);
}

TEST(Regression, secondary_errors_count_except_for_scenes_that_must_fall) {
    EXPECT_EQ(faults_in(changes_between({short_row("j1", 1, 1)}, {short_row("j1", 1, 2)}, true)),
              1);
    EXPECT_TRUE(
        changes_between({short_row("c10-mu0.17", 0, 1)}, {short_row("c10-mu0.17", 0, 2)}, true)
            .empty());
}

TEST(Regression, new_failed_run_is_a_regression) {
    EXPECT_EQ(faults_in(changes_between({short_row("j1", 1)}, {failed_row("j1")}, true)), 1);
    EXPECT_EQ(faults_in(changes_between({failed_row("j1")}, {short_row("j1", 1)}, true)), 0);
    EXPECT_TRUE(changes_between({failed_row("j1")}, {failed_row("j1")}, true).empty());
}

TEST(Regression, unmatched_rows_are_regressions) {
    EXPECT_EQ(faults_in(changes_between({}, {short_row("j1", 1)}, true)), 1);
    EXPECT_EQ(faults_in(changes_between({short_row("j1", 1)}, {}, true)), 1);
    EXPECT_EQ(faults_in(changes_between({short_row("j1", 1)}, {}, false)), 0);
    const std::vector<Row> two = {short_row("j1", 1), short_row("j1", 1, 0, 120)};
    EXPECT_EQ(faults_in(changes_between(two, {short_row("j1", 1)}, false)), 1);
}

TEST(Regression, excludes_slow_scenes) {
    EXPECT_TRUE(in_regression_set(*find_experiment("j1")));
    EXPECT_FALSE(in_regression_set(*find_experiment("c17-cloth")));
}

}  // namespace
