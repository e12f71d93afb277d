// SPDX-License-Identifier: MIT
//
// The numerical methods; methods.cpp measures their solutions.
#pragma once

#include "jostle/analysis/methods.h"

namespace jostle::analysis {

struct SolverResult {
    std::vector<double> x;
    std::string failed;
    bool converged = true;
    std::vector<double> residuals;
};

SolverResult solve_directly(const Problem& problem, Method method);
SolverResult solve_by_iteration(const Problem& problem, Method method, const SolverLimits& limits);

// b - A x| / |b|.
double equation_residual(const Problem& problem, const std::vector<double>& x);
// See Solution::residual of the projected method.
double natural_residual(const Problem& problem, const std::vector<double>& x);

}  // namespace jostle::analysis
