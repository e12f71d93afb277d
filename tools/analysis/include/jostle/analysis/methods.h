// SPDX-License-Identifier: MIT
//
// One problem solved in every way that the field knows, side by side. Direct methods take all rows
// as equations, as if nothing had bounds; so do Gauss-Seidel and conjugate gradients. Projected
// Gauss-Seidel keeps to the bounds: it is what game solvers run, for all contacts at once.
#pragma once

#include "jostle/analysis/problem.h"

namespace jostle::linear_systems {

enum class Method {
    gauss,         // elimination with partial pivoting, as in the textbook
    lu,            // the same as two factors, in blocks
    cholesky,      // L L^T; only of what is positive definite
    ldlt,          // L D L^T with pivoting
    qr,            // least squares, by columns with pivoting
    minimum_norm,  // least squares of least |x|: the pseudo-inverse, by singular values
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
    int iterations_max = 1000;  // a sweep over all rows is one
    double tolerance = 1e-10;   // of the residual
};

struct Solution {
    Method method = Method::gauss;
    std::string failed;     // why there is no x; empty: there is
    std::vector<double> x;  // N s, N m s
    // |b - A x| / |b|; of the projected method the natural residual, of which a row at a bound that
    // is pushed beyond it has none: |A_ii (x_i - bounded(x_i + (b - A x)_i / A_ii))| / |b|.
    double residual = 0;
    int out_of_bounds = 0;  // rows whose impulse is beyond a bound, by 1e-6 of the largest impulse
    double size = 0;        // |x|
    double milliseconds = 0;  // of this thread
    bool converged = true;
    std::vector<double> residuals;  // after each iteration

    int iterations() const { return static_cast<int>(residuals.size()); }
};

Solution solve(const Problem& problem, Method method, const SolverLimits& limits = {});
// By all of them, in their order.
std::vector<Solution> solve_all(const Problem& problem, const SolverLimits& limits = {});

}  // namespace jostle::linear_systems
