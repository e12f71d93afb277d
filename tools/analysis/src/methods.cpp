// SPDX-License-Identifier: MIT
#include "jostle/analysis/methods.h"

#include <algorithm>
#include <cmath>

#include "jostle/analysis/work_error.h"
#include "tools/analysis/src/solvers.h"

namespace jostle::analysis {
namespace {

int rows_out_of_bounds(const Problem& problem, const std::vector<double>& x) {
    double most = 0;
    for (const double value : x) most = std::max(most, std::abs(value));
    const double slack = 1e-6 * most;
    int count = 0;
    for (std::size_t k = 0; k < x.size(); k++)
        count += x[k] < problem.lower_at(k, x) - slack || x[k] > problem.upper_at(k, x) + slack;
    return count;
}

}  // namespace

const char* name_of(Method method) {
    switch (method) {
        case Method::gauss:
            return "Gauss elimination";
        case Method::lu:
            return "LU";
        case Method::cholesky:
            return "Cholesky";
        case Method::ldlt:
            return "LDL^T";
        case Method::qr:
            return "least squares (QR)";
        case Method::minimum_norm:
            return "minimum norm (SVD)";
        case Method::gauss_seidel:
            return "Gauss-Seidel";
        case Method::projected_gauss_seidel:
            return "projected Gauss-Seidel";
        case Method::conjugate_gradients:
            return "conjugate gradients";
    }
    return "";
}

bool iterates(Method method) {
    return method >= Method::gauss_seidel;
}

Solution solve(const Problem& problem, Method method, const SolverLimits& limits) {
    const double start = thread_seconds();
    SolverResult result = iterates(method) ? solve_by_iteration(problem, method, limits)
                                           : solve_directly(problem, method);
    Solution solution{.method = method,
                      .failed = std::move(result.failed),
                      .x = std::move(result.x),
                      .milliseconds = 1e3 * (thread_seconds() - start),
                      .converged = result.converged,
                      .residuals = std::move(result.residuals)};
    if (!solution.failed.empty()) return solution;
    solution.residual = method == Method::projected_gauss_seidel
                            ? natural_residual(problem, solution.x)
                            : equation_residual(problem, solution.x);
    solution.out_of_bounds = rows_out_of_bounds(problem, solution.x);
    for (const double value : solution.x) solution.size += value * value;
    solution.size = std::sqrt(solution.size);
    return solution;
}

std::vector<Solution> solve_all(const Problem& problem, const SolverLimits& limits) {
    std::vector<Solution> all;
    for (const Method method : all_methods) all.push_back(solve(problem, method, limits));
    return all;
}

}  // namespace jostle::analysis
