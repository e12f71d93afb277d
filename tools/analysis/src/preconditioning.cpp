// SPDX-License-Identifier: MIT
#include "jostle/analysis/preconditioning.h"

#include <limits>

#include "tools/analysis/src/eigen_view.h"
#include "tools/analysis/src/solvers.h"

namespace jostle::analysis {
namespace {

PreconditioningResult evaluate(const Problem& problem, const Problem& basis,
                               const Analysis& analysis, bool scaled, double epsilon,
                               const SolverLimits& limits) {
    PreconditioningResult result{.scaled = scaled, .epsilon = epsilon};
    Problem soft = basis;
    double most = 0;
    for (std::size_t k = 0; k < basis.count; k++) most = std::max(most, basis.at(k, k));
    const double added = epsilon * most;
    for (std::size_t k = 0; k < basis.count; k++) soft.matrix[k * basis.count + k] += added;

    const std::vector<double>& values = scaled ? analysis.scaled_eigenvalues : analysis.eigenvalues;
    // Treats an eigenvalue that is zero up to rounding as zero.
    const double least = (analysis.singular() ? 0 : values.front()) + added;
    result.condition =
        least > 0 ? (values.back() + added) / least : std::numeric_limits<double>::infinity();

    const Solution gradients = solve(soft, Method::conjugate_gradients, limits);
    const Solution sweeps = solve(soft, Method::gauss_seidel, limits);
    result.gradient_iterations = gradients.iterations();
    result.gradients_converged = gradients.converged;
    result.sweeps = sweeps.iterations();
    result.sweeps_converged = sweeps.converged;
    std::vector<double> x = gradients.x;
    if (scaled) {
        const Eigen::VectorXd d = scaling_of(problem);
        for (std::size_t k = 0; k < x.size(); k++) x[k] *= d(static_cast<Eigen::Index>(k));
    }
    result.error = equation_residual(problem, x);
    return result;
}

}  // namespace

std::vector<PreconditioningResult> evaluate_preconditioning(const Problem& problem,
                                                            const Analysis& analysis,
                                                            const SolverLimits& limits,
                                                            std::span<const double> epsilons) {
    std::vector<PreconditioningResult> all;
    if (problem.count == 0) return all;
    const Eigen::MatrixXd matrix = scaled_matrix(problem);
    const Eigen::VectorXd rhs = scaling_of(problem).asDiagonal() * to_eigen_vector(problem.rhs);
    const Problem scaled = problem_of(problem.count, {matrix.data(), matrix.data() + matrix.size()},
                                      to_std_vector(rhs));
    for (const bool with : {false, true})
        for (const double epsilon : epsilons)
            all.push_back(
                evaluate(problem, with ? scaled : problem, analysis, with, epsilon, limits));
    return all;
}

}  // namespace jostle::analysis
