// SPDX-License-Identifier: MIT
//
// The methods themselves, without what all solutions are measured by (methods.cpp).
#pragma once

#include "jostle/analysis/methods.h"

namespace jostle::linear_systems {

struct SolverResult {
    std::vector<double> x;
    std::string failed;
    bool converged = true;
    std::vector<double> residuals;
};

SolverResult solve_directly(const Problem& problem, Method method);
SolverResult solve_by_iteration(const Problem& problem, Method method, const SolverLimits& limits);

// |b - A x| / |b|.
double equation_residual(const Problem& problem, const std::vector<double>& x);
// As Solution::residual says of the projected method.
double natural_residual(const Problem& problem, const std::vector<double>& x);

}  // namespace jostle::linear_systems
