// SPDX-License-Identifier: MIT
//
// Choices of --converge among synthetic rows.
#include "tools/sim/converge.h"

#include <gtest/gtest.h>

namespace {

using namespace jostle::sim;

ConvergenceRow row_of(double hz, int substeps, double error, double cost) {
    return {.setting = {hz, substeps}, .error = error, .cpu_us_per_second = cost};
}

StepSettings cheapest(std::vector<ConvergenceRow> rows) {
    const Convergence found{.reference_error = 1e-6, .rows = std::move(rows)};
    return found.cheapest(0.01)->setting;
}

TEST(Converge, settings_within_15_percent_of_the_least_time_tie) {
    EXPECT_EQ(cheapest({row_of(60, 2, 0.001, 114), row_of(60, 8, 0.001, 100)}),
              (StepSettings{60, 2}));
    EXPECT_EQ(cheapest({row_of(120, 2, 0.001, 116), row_of(60, 8, 0.002, 100)}),
              (StepSettings{60, 8}));
    EXPECT_EQ(cheapest({row_of(60, 2, 0.02, 100), row_of(60, 8, 0.001, 101)}),
              (StepSettings{60, 8}))
        << "the other one is not accurate enough";
}

TEST(Converge, equal_errors_at_one_rate_tie_at_any_time) {
    EXPECT_EQ(cheapest({row_of(60, 1, 0.001, 300), row_of(60, 8, 0.001, 100)}),
              (StepSettings{60, 1}));
}

TEST(Converge, lower_rate_wins_among_equal_sub_steps) {
    EXPECT_EQ(cheapest({row_of(120, 4, 0.001, 100), row_of(60, 4, 0.001, 105)}),
              (StepSettings{60, 4}));
}

TEST(Converge, marks_errors_that_grow_by_a_third) {
    std::vector<ConvergenceRow> rows = {row_of(30, 4, 0.003, 1),   row_of(60, 4, 0.0039, 2),
                                        row_of(120, 4, 0.0041, 4), row_of(240, 4, 0.001, 8),
                                        row_of(30, 8, 0.0001, 2),  row_of(60, 8, 0.0001, 4)};
    mark_worse(rows);
    for (std::size_t k = 0; k < rows.size(); k++)
        EXPECT_EQ(rows[k].worse_than_hz, k == 2 ? std::optional(30.0) : std::nullopt) << k;
}

}  // namespace
