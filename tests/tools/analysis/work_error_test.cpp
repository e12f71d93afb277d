// SPDX-License-Identifier: MIT
#include "jostle/analysis/work_error.h"

#include <gtest/gtest.h>

namespace {

using namespace jostle::analysis;

TEST(ObservedOrder, is_the_logarithm_of_the_error_ratio_to_base_refinement) {
    EXPECT_NEAR(*observed_order(0.04, 0.01, 2), 2, 1e-12);
    EXPECT_NEAR(*observed_order(0.02, 0.01, 4), 0.5, 1e-12);
    EXPECT_NEAR(*observed_order(0.01, 0.02, 2), -1, 1e-12);
}

TEST(ObservedOrder, is_empty_for_invalid_errors_or_refinement) {
    EXPECT_FALSE(observed_order(0, 0.01, 2));
    EXPECT_FALSE(observed_order(0.01, 0, 2));
    EXPECT_FALSE(observed_order(0.01, 0.005, 1));
    EXPECT_FALSE(observed_order(std::nan(""), 0.01, 2));
}

const std::vector<WorkError> is_running = {{10, 0.1}, {5, 0.1}, {20, 0.2}, {40, 0.001}, {5, 0.3}};

TEST(ParetoSet, excludes_dominated_runs) {
    EXPECT_EQ(pareto_set(is_running), (std::vector<std::size_t>{1, 3}));
    EXPECT_TRUE(pareto_set({}).empty());
}

TEST(LeastWork, returns_the_cheapest_run_within_the_tolerance) {
    EXPECT_EQ(least_work(is_running, 0.3), 1u);  // not the last one, which costs the same
    EXPECT_EQ(least_work(is_running, 0.01), 3u);
    EXPECT_FALSE(least_work(is_running, 1e-6));
}

TEST(Rms, is_zero_without_samples) {
    Rms rms;
    EXPECT_EQ(rms.value(), 0);
    rms.add(9);
    rms.add(16);
    EXPECT_DOUBLE_EQ(rms.value(), std::sqrt(12.5));
}

TEST(ThreadSeconds, increase_while_the_thread_is_busy) {
    const double before = thread_seconds();
    volatile double sum = 0;
    while (thread_seconds() - before < 0.001) sum = sum + 1;
    EXPECT_GT(sum, 0);
}

}  // namespace
