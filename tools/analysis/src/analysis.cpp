// SPDX-License-Identifier: MIT
#include "jostle/analysis/analysis.h"

#include <algorithm>
#include <cstdio>

#include "tools/analysis/src/eigen_view.h"

namespace jostle::analysis {
namespace {

using Eigen::Index;

double condition_of(const std::vector<double>& rising, std::size_t rank) {
    if (rank == 0) return 1;
    return rising.back() / rising[rising.size() - rank];
}

// Reduced basis of the null space: each vector has its own row with factor one, in which all others
// are zero. Later rows are preferred if their factor is a sufficient share of the largest.
Eigen::MatrixXd reduced(Eigen::MatrixXd space, std::vector<std::size_t>& own) {
    constexpr double fair = 0.1;
    for (Index k = 0; k < space.cols(); k++) {
        const double most = space.rightCols(space.cols() - k).cwiseAbs().maxCoeff();
        Index row = space.rows() - 1, column = k;
        for (; row >= 0; row--) {
            const double here =
                space.row(row).rightCols(space.cols() - k).cwiseAbs().maxCoeff(&column);
            if (here >= fair * most) break;
        }
        space.col(k).swap(space.col(column + k));
        space.col(k) /= space(row, k);
        for (Index other = 0; other < space.cols(); other++)
            if (other != k) space.col(other) -= space(row, other) * space.col(k);
        own.push_back(static_cast<std::size_t>(row));
    }
    return space;
}

std::vector<Redundancy> redundancies_of(const Eigen::MatrixXd& space) {
    constexpr double nothing = 1e-9;
    std::vector<std::size_t> own;
    const Eigen::MatrixXd basis = reduced(space, own);
    std::vector<Redundancy> all;
    for (Index k = 0; k < basis.cols(); k++) {
        Redundancy result{.row = own[static_cast<std::size_t>(k)]};
        const double most = basis.col(k).cwiseAbs().maxCoeff();
        for (Index row = 0; row < basis.rows(); row++)
            if (static_cast<std::size_t>(row) != result.row &&
                std::abs(basis(row, k)) > nothing * most)
                result.of.push_back({static_cast<std::size_t>(row), -basis(row, k)});
        all.push_back(std::move(result));
    }
    std::sort(all.begin(), all.end(),
              [](const Redundancy& a, const Redundancy& b) { return a.row < b.row; });
    return all;
}

}  // namespace

Analysis analyse(const Problem& problem) {
    Analysis result;
    if (problem.count == 0) return result;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> plain(to_eigen_matrix(problem),
                                                               Eigen::EigenvaluesOnly);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> scaled(scaled_matrix(problem));
    result.eigenvalues = to_std_vector(plain.eigenvalues());
    result.scaled_eigenvalues = to_std_vector(scaled.eigenvalues());
    const double zero = zero_tolerance(problem.count) * result.scaled_eigenvalues.back();
    result.rank = static_cast<std::size_t>(
        std::count_if(result.scaled_eigenvalues.begin(), result.scaled_eigenvalues.end(),
                      [&](double value) { return value > zero; }));
    result.condition = condition_of(result.eigenvalues, result.rank);
    result.scaled_condition = condition_of(result.scaled_eigenvalues, result.rank);
    if (!result.singular()) return result;
    // A (D y) = 0 if D A D y = 0.
    const auto missing = static_cast<Index>(problem.count - result.rank);
    const Eigen::MatrixXd space =
        scaling_of(problem).asDiagonal() * scaled.eigenvectors().leftCols(missing);
    result.redundancies = redundancies_of(space);
    const auto rhs = to_eigen_vector(problem.rhs);
    const Eigen::VectorXd scaled_right = scaling_of(problem).asDiagonal() * rhs;
    if (rhs.norm() > 0)
        result.inconsistency =
            (scaled.eigenvectors().leftCols(missing).transpose() * scaled_right).norm() /
            scaled_right.norm();
    return result;
}

std::string to_text(const Redundancy& redundancy, const Problem& problem, int terms_max) {
    std::string words = problem.names[redundancy.row] + " =";
    if (redundancy.of.empty()) return words + " nothing";
    std::vector<Term> shares = redundancy.of;
    const auto most = static_cast<std::size_t>(terms_max);
    if (shares.size() > most)
        std::stable_sort(shares.begin(), shares.end(), [](const Term& a, const Term& b) {
            return std::abs(a.factor) > std::abs(b.factor);
        });
    for (std::size_t k = 0; k < shares.size() && k < most; k++) {
        const double size = std::abs(shares[k].factor);
        char factor[32] = "";
        if (std::abs(size - 1) > 1e-6) std::snprintf(factor, sizeof factor, "%.4g ", size);
        words += shares[k].factor < 0 ? (k == 0 ? " -" : " - ") : (k == 0 ? " " : " + ");
        words += factor + problem.names[shares[k].row];
    }
    if (shares.size() > most) words += " and " + std::to_string(shares.size() - most) + " more";
    return words;
}

}  // namespace jostle::analysis
