// SPDX-License-Identifier: MIT
//
// Eigen views of a problem. The only file that includes Eigen.
#pragma once

#define EIGEN_MPL2_ONLY
#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "jostle/analysis/problem.h"

namespace jostle::analysis {

// The matrix is symmetric, so its storage order does not matter.
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

// One over the square root of the diagonal: D A D has ones on the diagonal.
inline Eigen::VectorXd scaling_of(const Problem& problem) {
    return to_eigen_matrix(problem).diagonal().unaryExpr(
        [](double x) { return x > 0 ? 1 / std::sqrt(x) : 1.0; });
}
inline Eigen::MatrixXd scaled_matrix(const Problem& problem) {
    const Eigen::VectorXd d = scaling_of(problem);
    return d.asDiagonal() * to_eigen_matrix(problem) * d.asDiagonal();
}

// Eigenvalues up to this share of the largest count as zero: the rounding error of sums of `count`
// terms, with a margin.
inline double zero_tolerance(std::size_t count) {
    return 1e-14 * static_cast<double>(std::max<std::size_t>(count, 10));
}

}  // namespace jostle::analysis
