// SPDX-License-Identifier: MIT
//
// Effect of preconditioning on the condition number, and its cost: softness on the diagonal
// (Tikhonov regularization; constraint force mixing in game engines) and scaling of each row by its
// diagonal (Jacobi preconditioner).
#pragma once

#include <span>

#include "jostle/analysis/analysis.h"
#include "jostle/analysis/methods.h"

namespace jostle::analysis {

struct PreconditioningResult {
    bool scaled = false;
    double epsilon = 0;  ///< softness relative to the largest diagonal entry (scaled: to one)
    /// Largest over smallest eigenvalue, including zeros: infinite if the smallest is zero.
    double condition = 0;
    /// Iterations until the residual of the treated problem is below SolverLimits::tolerance; above
    /// the limit: not reached. Scaling does not change the number of sweeps.
    int gradient_iterations = 0, sweeps = 0;
    bool gradients_converged = false, sweeps_converged = false;
    /// b - A x| / |b| of the original problem, with the solution of conjugate gradients
    double error = 0;
};

inline constexpr double default_epsilons[] = {0, 1e-12, 1e-9, 1e-6, 1e-3};

/// Evaluates each epsilon, first unscaled, then scaled.
std::vector<PreconditioningResult> evaluate_preconditioning(
    const Problem& problem, const Analysis& analysis, const SolverLimits& limits = {},
    std::span<const double> epsilons = default_epsilons);

}  // namespace jostle::analysis
