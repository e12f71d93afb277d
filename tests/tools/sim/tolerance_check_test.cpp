// SPDX-License-Identifier: MIT
//
// The verdict on an error tolerance, with synthetic islands.
#include "tools/sim/tolerance_check.h"

#include <gtest/gtest.h>

namespace {

using jostle::physics::IslandSubsteps;
using jostle::sim::ToleranceCheck;
using jostle::sim::ToleranceVerdict;

IslandSubsteps island(std::uint32_t body, double error) {
    return {.body = {body, 0}, .bodies = 1, .contacts = 1, .error = error};
}

// Steps of 0.1 s.
ToleranceVerdict run(const std::vector<std::vector<IslandSubsteps>>& steps) {
    ToleranceCheck check(0.01, 10);
    for (const auto& islands : steps) check.add(islands);
    return check.verdict();
}

TEST(ToleranceCheck, error_of_a_second_is_the_mean_of_its_estimates) {
    std::vector<std::vector<IslandSubsteps>> steps(20, {island(1, 0.008), island(2, 0.002)});
    EXPECT_TRUE(run(steps).within());
    EXPECT_NEAR(run(steps).worst, 0.008, 1e-12);
    steps[4] = {island(1, 0.027), island(2, 0.002)};  // 0.0019 m more within a second
    EXPECT_TRUE(run(steps).within());
    EXPECT_NEAR(run(steps).worst, 0.0099, 1e-12);
    steps[5] = steps[4];
    const ToleranceVerdict over = run(steps);
    EXPECT_EQ(over.islands_over, 1);
    EXPECT_NEAR(over.worst, 0.0118, 1e-12);
    EXPECT_EQ(to_text(over), "error tolerance 0.01 m: not kept: 1 island, worst 0.012 m\n");
}

TEST(ToleranceCheck, islands_that_fell_asleep_count) {
    std::vector<std::vector<IslandSubsteps>> steps(30);
    for (std::size_t k = 0; k < 12; k++) steps[k] = {island(1, 0.02), island(2, 0.03)};
    const ToleranceVerdict over = run(steps);
    EXPECT_EQ(over.islands_over, 2);
    EXPECT_NEAR(over.worst, 0.03, 1e-12);
}

TEST(ToleranceCheck, run_of_less_than_a_second_counts_as_a_whole) {
    EXPECT_NEAR(run({{island(1, 0.004)}, {island(1, 0.008)}}).worst, 0.006, 1e-12);
    EXPECT_EQ(to_text(run({{island(1, 0.004)}})), "error tolerance 0.01 m: kept\n");
}

TEST(ToleranceCheck, unknown_errors_are_not_measured) {
    EXPECT_EQ(to_text(run({{island(1, 0)}, {}})),
              "error tolerance 0.01 m: not measured: no island has contacts or joints\n");
}

}  // namespace
