// SPDX-License-Identifier: MIT
#include "jostle/analysis/methods.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace jostle::analysis {
namespace {

using testing::HasSubstr;

// Symmetric and positive definite: B B^T + 1 with an unstructured B.
Problem solid(std::size_t n, std::vector<double>& x) {
    std::vector<double> b(n * n), a(n * n), right(n);
    for (std::size_t k = 0; k < n * n; k++) b[k] = std::sin(static_cast<double>(k * k + 1));
    x.clear();
    for (std::size_t k = 0; k < n; k++) x.push_back(std::cos(static_cast<double>(3 * k)));
    for (std::size_t i = 0; i < n; i++)
        for (std::size_t j = 0; j < n; j++) {
            for (std::size_t k = 0; k < n; k++) a[i * n + j] += b[i * n + k] * b[j * n + k];
            if (i == j) a[i * n + j] += 1;
        }
    for (std::size_t i = 0; i < n; i++)
        for (std::size_t j = 0; j < n; j++) right[i] += a[i * n + j] * x[j];
    return problem_of(n, a, right);
}

TEST(Methods, all_methods_find_the_unique_solution) {
    std::vector<double> x;
    const Problem problem = solid(8, x);
    const std::vector<Solution> all = solve_all(problem, {.iterations_max = 5000});
    ASSERT_EQ(all.size(), std::size(all_methods));
    for (const Solution& solution : all) {
        SCOPED_TRACE(name_of(solution.method));
        ASSERT_EQ(solution.failed, "");
        EXPECT_TRUE(solution.converged);
        EXPECT_LT(solution.residual, 1e-10);
        EXPECT_EQ(solution.out_of_bounds, 0);
        for (std::size_t k = 0; k < x.size(); k++) EXPECT_NEAR(solution.x[k], x[k], 1e-8);
        EXPECT_EQ(iterates(solution.method), solution.iterations() > 0);
    }
}

// Two equal rows: any distribution between them is a solution.
TEST(Methods, redundant_rows_have_a_minimum_norm_solution) {
    const Problem problem = problem_of(2, {1, 1, 1, 1}, {2, 2});
    const Solution least = solve(problem, Method::minimum_norm);
    EXPECT_NEAR(least.x[0], 1, 1e-14);
    EXPECT_NEAR(least.x[1], 1, 1e-14);
    EXPECT_THAT(solve(problem, Method::gauss).failed, HasSubstr("row 1"));
    EXPECT_THAT(solve(problem, Method::lu).failed, HasSubstr("row 1"));
    EXPECT_THAT(solve(problem, Method::cholesky).failed, HasSubstr("not positive definite"));
    for (const Method method : {Method::ldlt, Method::qr, Method::gauss_seidel,
                                Method::projected_gauss_seidel, Method::conjugate_gradients}) {
        SCOPED_TRACE(name_of(method));
        const Solution solution = solve(problem, method);
        ASSERT_EQ(solution.failed, "");
        EXPECT_NEAR(solution.x[0] + solution.x[1], 2, 1e-12);
        EXPECT_LT(solution.residual, 1e-12);
        EXPECT_GE(solution.size, least.size - 1e-12);
    }
}

// Contradictory right-hand sides: least squares leaves half of the difference.
TEST(Methods, inconsistent_rows_give_the_least_squares_solution) {
    const Problem problem = problem_of(2, {1, 1, 1, 1}, {2, 0});
    for (const Method method : {Method::minimum_norm, Method::qr}) {
        const Solution solution = solve(problem, method);
        EXPECT_NEAR(solution.x[0] + solution.x[1], 1, 1e-12);
        EXPECT_NEAR(solution.residual, std::sqrt(0.5), 1e-12);
    }
    EXPECT_FALSE(solve(problem, Method::gauss_seidel).converged);
}

// For [1 r; r 1] the error decreases by r^2 per sweep.
TEST(Methods, gauss_seidel_converges_at_the_theoretical_rate) {
    const double r = 0.6;
    const Solution swept = solve(problem_of(2, {1, r, r, 1}, {1, 0}), Method::gauss_seidel);
    ASSERT_GT(swept.iterations(), 10);
    for (std::size_t k = 1; k < 10; k++)
        EXPECT_NEAR(swept.residuals[k] / swept.residuals[k - 1], r * r, 1e-6);
}

// One iteration per distinct eigenvalue.
TEST(Methods, conjugate_gradients_end_after_as_many_steps_as_distinct_eigenvalues) {
    std::vector<double> a(25);
    const double values[] = {1, 1, 4, 4, 9};
    for (std::size_t k = 0; k < 5; k++) a[6 * k] = values[k];
    const Solution solution = solve(problem_of(5, a, {1, 2, 3, 4, 5}), Method::conjugate_gradients);
    EXPECT_EQ(solution.iterations(), 3);
    EXPECT_TRUE(solution.converged);
    EXPECT_LT(solution.residual, 1e-12);
}

// 1 kg on a floor, pushed sideways: the floor must not pull, and the friction must not exceed mu N.
TEST(Methods, projected_gauss_seidel_respects_the_bounds) {
    Problem problem = problem_of(2, {1, 0, 0, 1}, {3, 4});
    problem.lower = {0, 0};
    problem.normal_row = {-1, 0};
    problem.friction = {0, 0.5};
    Solution solution = solve(problem, Method::projected_gauss_seidel);
    EXPECT_NEAR(solution.x[0], 3, 1e-12);
    EXPECT_NEAR(solution.x[1], 1.5, 1e-12);
    EXPECT_EQ(solution.residual, 0);
    EXPECT_EQ(solve(problem, Method::gauss).out_of_bounds, 1);
    problem.rhs[0] = -3;  // it lifts off
    solution = solve(problem, Method::projected_gauss_seidel);
    EXPECT_EQ(solution.x[0], 0);
    EXPECT_EQ(solution.x[1], 0);
    EXPECT_TRUE(problem.has_bounds());
    EXPECT_FALSE(problem_of(1, {1}, {1}).has_bounds());
}

TEST(Methods, zero_right_hand_side_gives_a_zero_solution) {
    for (const Solution& solution : solve_all(problem_of(2, {2, 0, 0, 3}, {0, 0}))) {
        SCOPED_TRACE(name_of(solution.method));
        EXPECT_TRUE(solution.converged);
        EXPECT_EQ(solution.residual, 0);
        EXPECT_EQ(solution.size, 0);
    }
}

}  // namespace
}  // namespace jostle::analysis
