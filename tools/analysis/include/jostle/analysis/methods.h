// SPDX-License-Identifier: MIT
//
// Solves one problem with several numerical methods for comparison. The direct methods,
// Gauss-Seidel and conjugate gradients treat all rows as equations and ignore the bounds. Projected
// Gauss-Seidel respects the bounds; game solvers use it for all contacts at once.
#pragma once

#include "jostle/analysis/problem.h"

namespace jostle::analysis {

enum class Method {
    gauss,         ///< elimination with partial pivoting
    lu,            ///< the same as two factors, in blocks
    cholesky,      ///< L L^T; positive definite matrices only
    ldlt,          ///< L D L^T with pivoting
    qr,            ///< least squares, with column pivoting
    minimum_norm,  ///< least squares with minimal |x|: the pseudo-inverse by singular values
    gauss_seidel,
    projected_gauss_seidel,
    conjugate_gradients,
};
inline constexpr Method all_methods[] = {Method::gauss,
                                         Method::lu,
                                         Method::cholesky,
                                         Method::ldlt,
                                         Method::qr,
                                         Method::minimum_norm,
                                         Method::gauss_seidel,
                                         Method::projected_gauss_seidel,
                                         Method::conjugate_gradients};
const char* name_of(Method method);
bool iterates(Method method);

struct SolverLimits {
    int iterations_max = 1000;  ///< one sweep over all rows is one iteration
    double tolerance = 1e-10;   ///< of the residual
};

struct Solution {
    Method method = Method::gauss;
    std::string failed;     ///< why there is no solution; empty: solved
    std::vector<double> x;  ///< N s, N m s
    /// b - A x| / |b|. For the projected method the natural residual |A_ii (x_i - bounded(x_i + (b
    /// - A x)_i / A_ii))| / |b|, which is zero for a row that is pushed against its bound.
    double residual = 0;
    /// rows whose impulse exceeds a bound by more than 1e-6 of the largest impulse
    int out_of_bounds = 0;
    double size = 0;          ///< |x|
    double milliseconds = 0;  ///< CPU time of this thread, ms
    bool converged = true;
    std::vector<double> residuals;  ///< after each iteration

    int iterations() const { return static_cast<int>(residuals.size()); }
};

Solution solve(const Problem& problem, Method method, const SolverLimits& limits = {});
/// Solves the problem with all methods, in the order of the enumeration.
std::vector<Solution> solve_all(const Problem& problem, const SolverLimits& limits = {});

}  // namespace jostle::analysis
