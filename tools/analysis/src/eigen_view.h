// SPDX-License-Identifier: MIT
//
// A problem as Eigen sees it. The one place that includes Eigen.
#pragma once

#define EIGEN_MPL2_ONLY
#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "jostle/analysis/problem.h"

namespace jostle::linear_systems {

// Symmetric, so rows are columns.
inline Eigen::Map<const Eigen::MatrixXd> to_eigen_matrix(const Problem& problem) {
    const auto count = static_cast<Eigen::Index>(problem.count);
    return {problem.matrix.data(), count, count};
}
inline Eigen::Map<const Eigen::VectorXd> to_eigen_vector(const std::vector<double>& v) {
    return {v.data(), static_cast<Eigen::Index>(v.size())};
}
inline std::vector<double> to_std_vector(const Eigen::VectorXd& v) {
    return {v.data(), v.data() + v.size()};
}

// One over the root of the diagonal: D A D has ones on its own.
inline Eigen::VectorXd scaling_of(const Problem& problem) {
    return to_eigen_matrix(problem).diagonal().unaryExpr(
        [](double x) { return x > 0 ? 1 / std::sqrt(x) : 1.0; });
}
inline Eigen::MatrixXd scaled_matrix(const Problem& problem) {
    const Eigen::VectorXd d = scaling_of(problem);
    return d.asDiagonal() * to_eigen_matrix(problem) * d.asDiagonal();
}

// Eigenvalues up to this part of the largest are zero: what rounding leaves of sums of so many
// terms, and some to spare.
inline double zero_tolerance(std::size_t count) {
    return 1e-14 * static_cast<double>(std::max<std::size_t>(count, 10));
}

}  // namespace jostle::linear_systems
