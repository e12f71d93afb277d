// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "tools/analysis/src/solvers.h"

namespace jostle::analysis {
namespace {

// Most rows share a body with few others.
class SparseRows {
public:
    explicit SparseRows(const Problem& problem) : first_{0} {
        for (std::size_t i = 0; i < problem.count; i++) {
            for (std::size_t j = 0; j < problem.count; j++)
                if (problem.at(i, j) != 0) entries_.push_back({j, problem.at(i, j)});
            first_.push_back(entries_.size());
        }
    }
    double times(std::size_t row, const std::vector<double>& x) const {
        double sum = 0;
        for (std::size_t k = first_[row]; k < first_[row + 1]; k++)
            sum += entries_[k].value * x[entries_[k].column];
        return sum;
    }

private:
    struct Entry {
        std::size_t column;
        double value;
    };
    std::vector<Entry> entries_;
    std::vector<std::size_t> first_;
};

double norm(const std::vector<double>& v) {
    double sum = 0;
    for (const double x : v) sum += x * x;
    return std::sqrt(sum);
}

double relative(double residual, const Problem& problem) {
    const double rhs = norm(problem.rhs);
    return rhs > 0 ? residual / rhs : residual;
}

double relative_residual(const Problem& problem, const SparseRows& rows,
                         const std::vector<double>& x) {
    double sum = 0;
    for (std::size_t i = 0; i < problem.count; i++) {
        const double left = problem.rhs[i] - rows.times(i, x);
        sum += left * left;
    }
    return relative(std::sqrt(sum), problem);
}

double bounded(const Problem& problem, std::size_t row, double value,
               const std::vector<double>& x) {
    return std::max(problem.lower_at(row, x), std::min(value, problem.upper_at(row, x)));
}

double relative_natural_residual(const Problem& problem, const SparseRows& rows,
                                 const std::vector<double>& x) {
    double sum = 0;
    for (std::size_t i = 0; i < problem.count; i++) {
        const double diagonal = problem.at(i, i);
        if (!(diagonal > 0)) continue;
        const double updated = x[i] + (problem.rhs[i] - rows.times(i, x)) / diagonal;
        const double left = diagonal * (x[i] - bounded(problem, i, updated, x));
        sum += left * left;
    }
    return relative(std::sqrt(sum), problem);
}

// Solves row after row with the current values of the other rows.
SolverResult sweep(const Problem& problem, bool within_bounds, const SolverLimits& limits) {
    const SparseRows rows(problem);
    SolverResult result;
    result.x.assign(problem.count, 0);
    result.converged = false;
    while (static_cast<int>(result.residuals.size()) < limits.iterations_max) {
        for (std::size_t i = 0; i < problem.count; i++) {
            const double diagonal = problem.at(i, i);
            if (!(diagonal > 0)) continue;
            const double now = result.x[i] + (problem.rhs[i] - rows.times(i, result.x)) / diagonal;
            result.x[i] = within_bounds ? bounded(problem, i, now, result.x) : now;
        }
        result.residuals.push_back(within_bounds
                                       ? relative_natural_residual(problem, rows, result.x)
                                       : relative_residual(problem, rows, result.x));
        if (result.residuals.back() <= limits.tolerance) {
            result.converged = true;
            break;
        }
        if (!(result.residuals.back() < 1e100)) break;
    }
    return result;
}

// Hestenes and Stiefel, 1952.
SolverResult by_conjugate_gradients(const Problem& problem, const SolverLimits& limits) {
    const SparseRows rows(problem);
    const std::size_t n = problem.count;
    SolverResult result;
    result.x.assign(n, 0);
    result.converged = false;
    std::vector<double> left = problem.rhs, direction = left, image(n);
    double size = 0;
    for (const double r : left) size += r * r;
    while (static_cast<int>(result.residuals.size()) < limits.iterations_max) {
        double bent = 0;
        for (std::size_t i = 0; i < n; i++) {
            image[i] = rows.times(i, direction);
            bent += direction[i] * image[i];
        }
        if (!(bent > 0)) break;  // converged, or the rest is outside the range of A
        const double step = size / bent;
        double next = 0;
        for (std::size_t i = 0; i < n; i++) {
            result.x[i] += step * direction[i];
            left[i] -= step * image[i];
            next += left[i] * left[i];
        }
        result.residuals.push_back(relative_residual(problem, rows, result.x));
        if (result.residuals.back() <= limits.tolerance) {
            result.converged = true;
            break;
        }
        for (std::size_t i = 0; i < n; i++) direction[i] = left[i] + next / size * direction[i];
        size = next;
    }
    if (size == 0) result.converged = true;
    return result;
}

}  // namespace

double equation_residual(const Problem& problem, const std::vector<double>& x) {
    return relative_residual(problem, SparseRows(problem), x);
}

double natural_residual(const Problem& problem, const std::vector<double>& x) {
    return relative_natural_residual(problem, SparseRows(problem), x);
}

SolverResult solve_by_iteration(const Problem& problem, Method method, const SolverLimits& limits) {
    if (method == Method::conjugate_gradients) return by_conjugate_gradients(problem, limits);
    return sweep(problem, method == Method::projected_gauss_seidel, limits);
}

}  // namespace jostle::analysis
