// SPDX-License-Identifier: MIT
//
// What makes a problem easier, and what that costs: softness on the diagonal (Tikhonov's
// regularisation; constraint force mixing, as games call it) and scaling each row by its own
// diagonal (Jacobi's preconditioner).
#pragma once

#include <span>

#include "jostle/analysis/analysis.h"
#include "jostle/analysis/methods.h"

namespace jostle::linear_systems {

struct PreconditioningResult {
    bool scaled = false;
    double epsilon = 0;  // what is added to the diagonal, by the largest of it (scaled: one)
    // Largest over smallest eigenvalue, all of them; infinite where the smallest is zero.
    double condition = 0;
    // To a residual of the treated problem of Effort::tolerance; beyond the most: not reached.
    // Sweeps do not change with scaling.
    int gradient_iterations = 0, sweeps = 0;
    bool gradients_converged = false, sweeps_converged = false;
    double error = 0;  // |b - A x| / |b| of the problem as it was, of what gradients found
};

inline constexpr double default_epsilons[] = {0, 1e-12, 1e-9, 1e-6, 1e-3};

// Unscaled, then scaled, with each epsilon.
std::vector<PreconditioningResult> evaluate_preconditioning(
    const Problem& problem, const Analysis& analysis, const SolverLimits& limits = {},
    std::span<const double> epsilons = default_epsilons);

}  // namespace jostle::linear_systems
