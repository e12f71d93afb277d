// SPDX-License-Identifier: MIT
#include <utility>

#include "tools/analysis/src/eigen_view.h"
#include "tools/analysis/src/solvers.h"

namespace jostle::analysis {
namespace {

using Eigen::Index;

std::string pivot_error(const Problem& problem, std::size_t row) {
    return "no nonzero pivot at row " + std::to_string(row) + ", " + problem.names[row];
}

SolverResult by_elimination(const Problem& problem) {
    const std::size_t n = problem.count;
    std::vector<double> a = problem.matrix, x = problem.rhs;
    std::vector<std::size_t> order(n);
    for (std::size_t k = 0; k < n; k++) order[k] = k;
    double most = 0;
    for (const double value : a) most = std::max(most, std::abs(value));
    const auto row = [&](std::size_t k) { return &a[order[k] * n]; };
    for (std::size_t k = 0; k < n; k++) {
        std::size_t best = k;
        for (std::size_t i = k + 1; i < n; i++)
            if (std::abs(row(i)[k]) > std::abs(row(best)[k])) best = i;
        std::swap(order[k], order[best]);
        const double pivot = row(k)[k];
        if (!(std::abs(pivot) > zero_tolerance(n) * most))
            return {.failed = pivot_error(problem, k)};
        for (std::size_t i = k + 1; i < n; i++) {
            const double factor = row(i)[k] / pivot;
            if (factor == 0) continue;
            for (std::size_t j = k; j < n; j++) row(i)[j] -= factor * row(k)[j];
            x[order[i]] -= factor * x[order[k]];
        }
    }
    std::vector<double> solved(n);
    for (std::size_t k = n; k-- > 0;) {
        double sum = x[order[k]];
        for (std::size_t j = k + 1; j < n; j++) sum -= row(k)[j] * solved[j];
        solved[k] = sum / row(k)[k];
    }
    return {.x = std::move(solved)};
}

SolverResult by_lu(const Problem& problem) {
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(to_eigen_matrix(problem));
    const Eigen::VectorXd pivots = lu.matrixLU().diagonal().cwiseAbs();
    Index least = 0;
    if (!(pivots.minCoeff(&least) > zero_tolerance(problem.count) * pivots.maxCoeff()))
        return {.failed = pivot_error(problem, static_cast<std::size_t>(least))};
    return {.x = to_std_vector(lu.solve(to_eigen_vector(problem.rhs)))};
}

SolverResult by_cholesky(const Problem& problem) {
    const Eigen::LLT<Eigen::MatrixXd> llt(to_eigen_matrix(problem));
    if (llt.info() != Eigen::Success) return {.failed = "not positive definite"};
    const Eigen::VectorXd pivots = llt.matrixLLT().diagonal();
    const double least = pivots.minCoeff(), most = pivots.maxCoeff();
    if (!(least * least > zero_tolerance(problem.count) * most * most))
        return {.failed = "not positive definite (zero pivot up to rounding)"};
    return {.x = to_std_vector(llt.solve(to_eigen_vector(problem.rhs)))};
}

// Skips zero pivots, which yields a solution if there is one.
SolverResult by_ldlt(const Problem& problem) {
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(to_eigen_matrix(problem));
    const Eigen::VectorXd d = ldlt.vectorD();
    const double zero = zero_tolerance(problem.count) * d.cwiseAbs().maxCoeff();
    Eigen::VectorXd x = ldlt.transpositionsP() * to_eigen_vector(problem.rhs);
    ldlt.matrixL().solveInPlace(x);
    for (Index k = 0; k < x.size(); k++) x(k) = std::abs(d(k)) > zero ? x(k) / d(k) : 0;
    ldlt.matrixU().solveInPlace(x);
    return {.x = to_std_vector(ldlt.transpositionsP().transpose() * x)};
}

SolverResult by_qr(const Problem& problem) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(to_eigen_matrix(problem).rows(),
                                                   to_eigen_matrix(problem).cols());
    qr.setThreshold(zero_tolerance(problem.count));
    qr.compute(to_eigen_matrix(problem));
    return {.x = to_std_vector(qr.solve(to_eigen_vector(problem.rhs)))};
}

// For a symmetric matrix without negative eigenvalues the eigenvalues are the singular values.
SolverResult by_singular_values(const Problem& problem) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> svd(to_eigen_matrix(problem));
    if (svd.info() != Eigen::Success) return {.failed = "singular value decomposition failed"};
    const double zero = zero_tolerance(problem.count) * svd.eigenvalues().cwiseAbs().maxCoeff();
    Eigen::VectorXd y = svd.eigenvectors().transpose() * to_eigen_vector(problem.rhs);
    for (Index k = 0; k < y.size(); k++)
        y(k) = svd.eigenvalues()(k) > zero ? y(k) / svd.eigenvalues()(k) : 0;
    return {.x = to_std_vector(svd.eigenvectors() * y)};
}

}  // namespace

SolverResult solve_directly(const Problem& problem, Method method) {
    switch (method) {
        case Method::gauss:
            return by_elimination(problem);
        case Method::lu:
            return by_lu(problem);
        case Method::cholesky:
            return by_cholesky(problem);
        case Method::ldlt:
            return by_ldlt(problem);
        case Method::qr:
            return by_qr(problem);
        case Method::minimum_norm:
            return by_singular_values(problem);
        default:
            return {.failed = "not a direct method"};
    }
}

}  // namespace jostle::analysis
