// SPDX-License-Identifier: MIT
#include <utility>

#include "tools/analysis/src/eigen_view.h"
#include "tools/analysis/src/solvers.h"

namespace jostle::linear_systems {
namespace {

using Eigen::Index;

std::string no_pivot(const Problem& problem, std::size_t row) {
    return "no pivot is left at row " + std::to_string(row) + ", " + problem.names[row];
}

SolverResult eliminate(const Problem& problem) {
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
        if (!(std::abs(pivot) > zero_share(n) * most)) return {.failed = no_pivot(problem, k)};
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
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix_of(problem));
    const Eigen::VectorXd pivots = lu.matrixLU().diagonal().cwiseAbs();
    Index least = 0;
    if (!(pivots.minCoeff(&least) > zero_share(problem.count) * pivots.maxCoeff()))
        return {.failed = no_pivot(problem, static_cast<std::size_t>(least))};
    return {.x = numbers_of(lu.solve(vector_of(problem.rhs)))};
}

SolverResult by_cholesky(const Problem& problem) {
    const Eigen::LLT<Eigen::MatrixXd> llt(matrix_of(problem));
    if (llt.info() != Eigen::Success) return {.failed = "not positive definite"};
    const Eigen::VectorXd pivots = llt.matrixLLT().diagonal();
    const double least = pivots.minCoeff(), most = pivots.maxCoeff();
    if (!(least * least > zero_share(problem.count) * most * most))
        return {.failed = "not positive definite, but for rounding"};
    return {.x = numbers_of(llt.solve(vector_of(problem.rhs)))};
}

// Pivots that are zero are left out: a solution, if there is one.
SolverResult by_ldlt(const Problem& problem) {
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(matrix_of(problem));
    const Eigen::VectorXd d = ldlt.vectorD();
    const double zero = zero_share(problem.count) * d.cwiseAbs().maxCoeff();
    Eigen::VectorXd x = ldlt.transpositionsP() * vector_of(problem.rhs);
    ldlt.matrixL().solveInPlace(x);
    for (Index k = 0; k < x.size(); k++) x(k) = std::abs(d(k)) > zero ? x(k) / d(k) : 0;
    ldlt.matrixU().solveInPlace(x);
    return {.x = numbers_of(ldlt.transpositionsP().transpose() * x)};
}

SolverResult by_qr(const Problem& problem) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix_of(problem).rows(),
                                                   matrix_of(problem).cols());
    qr.setThreshold(zero_share(problem.count));
    qr.compute(matrix_of(problem));
    return {.x = numbers_of(qr.solve(vector_of(problem.rhs)))};
}

// Of a symmetric matrix without negative eigenvalues they are the singular values.
SolverResult by_singular_values(const Problem& problem) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> svd(matrix_of(problem));
    if (svd.info() != Eigen::Success) return {.failed = "no singular values were found"};
    const double zero = zero_share(problem.count) * svd.eigenvalues().cwiseAbs().maxCoeff();
    Eigen::VectorXd y = svd.eigenvectors().transpose() * vector_of(problem.rhs);
    for (Index k = 0; k < y.size(); k++)
        y(k) = svd.eigenvalues()(k) > zero ? y(k) / svd.eigenvalues()(k) : 0;
    return {.x = numbers_of(svd.eigenvectors() * y)};
}

}  // namespace

SolverResult solve_directly(const Problem& problem, Method method) {
    switch (method) {
        case Method::gauss:
            return eliminate(problem);
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

}  // namespace jostle::linear_systems
