// SPDX-License-Identifier: MIT
#include "physics/src/constraints/contact_group/skyline_cholesky.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"

namespace jostle::physics {
namespace {

constexpr int n = SkylineCholesky::size, area = n * n;

// c -= a b^T
void subtract_product(double* c, const double* a, const double* b) {
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double sum = 0;
            for (int k = 0; k < n; k++) sum += a[n * i + k] * b[n * j + k];
            c[n * i + j] -= sum;
        }
}

// c = c L^-T with the lower triangle L of `diagonal`.
void divide_by_transpose(double* c, const double* diagonal) {
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double sum = c[n * i + j];
            for (int k = 0; k < j; k++) sum -= c[n * i + k] * diagonal[n * j + k];
            c[n * i + j] = sum / diagonal[n * j + j];
        }
}

void factor_diagonal(double* a) {
    for (int j = 0; j < n; j++) {
        double pivot = a[n * j + j];
        for (int k = 0; k < j; k++) pivot -= a[n * j + k] * a[n * j + k];
        const double root = square_root(maximum(pivot, 1));
        a[n * j + j] = root;
        for (int i = j + 1; i < n; i++) {
            double sum = a[n * i + j];
            for (int k = 0; k < j; k++) sum -= a[n * i + k] * a[n * j + k];
            a[n * i + j] = sum / root;
        }
    }
}

}  // namespace

void SkylineCholesky::set_pattern(std::span<const int> first) {
    first_.assign(first.begin(), first.end());
    begin_.resize(first.size() + 1);
    std::size_t all = 0;
    for (std::size_t i = 0; i < first.size(); i++) {
        ASSERT(first[i] >= 0 && first[i] <= static_cast<int>(i));
        begin_[i] = all;
        all += (i - static_cast<std::size_t>(first[i]) + 1) * area;
    }
    begin_[first.size()] = all;
    values_.resize(all);
}

void SkylineCholesky::set_identity() {
    std::fill(values_.begin(), values_.end(), 0.0);
    for (int i = 0; i < static_cast<int>(first_.size()); i++)
        for (int k = 0; k < n; k++) block(i, i)[(n + 1) * k] = 1;
}

double* SkylineCholesky::block(int i, int j) {
    const auto row = static_cast<std::size_t>(i);
    ASSERT(row < first_.size() && first_[row] <= j && j <= i);
    return values_.data() + begin_[row] + static_cast<std::size_t>(j - first_[row]) * area;
}
const double* SkylineCholesky::block(int i, int j) const {
    return const_cast<SkylineCholesky*>(this)->block(i, j);
}

void SkylineCholesky::factor() {
    for (int i = 0; i < static_cast<int>(first_.size()); i++) {
        const int first = first_[static_cast<std::size_t>(i)];
        for (int j = first; j <= i; j++) {
            double* at = block(i, j);
            const int from = std::max(first, first_[static_cast<std::size_t>(j)]);
            for (int k = from; k < j; k++) subtract_product(at, block(i, k), block(j, k));
            if (j < i)
                divide_by_transpose(at, block(j, j));
            else
                factor_diagonal(at);
        }
    }
}

void SkylineCholesky::solve(std::span<double> x) const {
    const int rows = static_cast<int>(first_.size());
    ASSERT(x.size() == first_.size() * n);
    for (int i = 0; i < rows; i++) {
        double* own = &x[static_cast<std::size_t>(n * i)];
        for (int k = first_[static_cast<std::size_t>(i)]; k < i; k++) {
            const double *l = block(i, k), *other = &x[static_cast<std::size_t>(n * k)];
            for (int r = 0; r < n; r++)
                for (int c = 0; c < n; c++) own[r] -= l[n * r + c] * other[c];
        }
        const double* l = block(i, i);
        for (int r = 0; r < n; r++) {
            for (int c = 0; c < r; c++) own[r] -= l[n * r + c] * own[c];
            own[r] /= l[(n + 1) * r];
        }
    }
    for (int i = rows - 1; i >= 0; i--) {
        double* own = &x[static_cast<std::size_t>(n * i)];
        const double* l = block(i, i);
        for (int r = n - 1; r >= 0; r--) {
            for (int c = r + 1; c < n; c++) own[r] -= l[n * c + r] * own[c];
            own[r] /= l[(n + 1) * r];
        }
        for (int k = first_[static_cast<std::size_t>(i)]; k < i; k++) {
            const double* up = block(i, k);
            double* other = &x[static_cast<std::size_t>(n * k)];
            for (int c = 0; c < n; c++)
                for (int r = 0; r < n; r++) other[c] -= up[n * r + c] * own[r];
        }
    }
}

}  // namespace jostle::physics
