// SPDX-License-Identifier: MIT
#include "jostle/analysis/problem.h"

#include <algorithm>

namespace jostle::analysis {
namespace {

constexpr double unbounded = 1e200;

std::string full_name(const physics::ConstraintRow& row) {
    if (!is_null(row.joint)) return "joint " + std::to_string(row.joint.index) + " " + name_of(row);
    return "contact " + std::to_string(row.shape_a.index) + "-" +
           std::to_string(row.shape_b.index) + " " + name_of(row);
}

}  // namespace

double Problem::lower_at(std::size_t row, const std::vector<double>& x) const {
    if (normal_row[row] < 0) return lower[row];
    return -friction[row] * std::max(x[static_cast<std::size_t>(normal_row[row])], 0.0);
}

double Problem::upper_at(std::size_t row, const std::vector<double>& x) const {
    if (normal_row[row] < 0) return upper[row];
    return friction[row] * std::max(x[static_cast<std::size_t>(normal_row[row])], 0.0);
}

bool Problem::has_bounds() const {
    for (std::size_t k = 0; k < count; k++)
        if (normal_row[k] >= 0 || lower[k] > -unbounded || upper[k] < unbounded) return true;
    return false;
}

Problem problem_of(const physics::ConstraintSystem& system) {
    Problem problem = problem_of(system.rows.size(), system.matrix, system.rhs);
    for (std::size_t k = 0; k < problem.count; k++) {
        const physics::ConstraintRow& row = system.rows[k];
        problem.lower[k] = row.lower;
        problem.upper[k] = row.upper;
        problem.normal_row[k] = row.normal_row;
        problem.friction[k] = row.friction;
        problem.names[k] = full_name(row);
    }
    return problem;
}

Problem problem_of(std::size_t count, std::vector<double> matrix, std::vector<double> rhs) {
    Problem problem{.count = count, .matrix = std::move(matrix), .rhs = std::move(rhs)};
    problem.lower.assign(count, -1e300);
    problem.upper.assign(count, 1e300);
    problem.normal_row.assign(count, -1);
    problem.friction.assign(count, 0);
    for (std::size_t k = 0; k < count; k++) problem.names.push_back("row " + std::to_string(k));
    return problem;
}

}  // namespace jostle::analysis
