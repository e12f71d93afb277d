// SPDX-License-Identifier: MIT
#include "physics/src/constraints/contact_group/skyline_cholesky.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"
#include "physics/src/constraints/contact_group/six.h"

namespace jostle::physics {
namespace {

constexpr int n = SkylineCholesky::size, area = n * n;

// c -= a b^T
void subtract_product(double* c, const double* a, const double* b) {
    Six columns[n];
    for (int k = 0; k < n; k++) columns[k] = load_six(a + n * k);
    for (int j = 0; j < n; j++) {
        Six sum = load_six(c + n * j);
        for (int k = 0; k < n; k++) sum = sum - columns[k] * b[n * k + j];
        store_six(c + n * j, sum);
    }
}

// c = c L^-T with the lower triangle L of `diagonal`.
void divide_by_transpose(double* c, const double* diagonal, const double* inverse) {
    Six columns[n];
    for (int j = 0; j < n; j++) {
        Six sum = load_six(c + n * j);
        for (int k = 0; k < j; k++) sum = sum - columns[k] * diagonal[n * k + j];
        columns[j] = sum * inverse[j];
        store_six(c + n * j, columns[j]);
    }
}

void factor_diagonal(double* a, double* inverse) {
    for (int j = 0; j < n; j++) {
        double* own = a + n * j;
        inverse[j] = 1 / square_root(maximum(own[j], 1));
        const Six column = load_six(own) * inverse[j];
        store_six(own, column);
        for (int k = j + 1; k < n; k++) {
            double* later = a + n * k;
            store_six(later, load_six(later) - column * own[k]);
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
    products_ = 0;
    for (std::size_t i = 0; i < first.size(); i++)
        for (int j = first[i]; j <= static_cast<int>(i); j++)
            products_ += j - std::max(first[i], first[static_cast<std::size_t>(j)]) + 1;
    values_.resize(all);
    inverse_.resize(n * first.size());
}

void SkylineCholesky::set_identity() {
    std::fill(values_.begin(), values_.end(), 0.0);
    for (int i = 0; i < static_cast<int>(first_.size()); i++)
        for (int k = 0; k < n; k++) block(i, i)[(n + 1) * k] = 1;
}

void SkylineCholesky::factor() {
    for (int i = 0; i < static_cast<int>(first_.size()); i++) {
        const int first = first_[static_cast<std::size_t>(i)];
        for (int j = first; j <= i; j++) {
            double* at = block(i, j);
            const int from = std::max(first, first_[static_cast<std::size_t>(j)]);
            for (int k = from; k < j; k++) subtract_product(at, block(i, k), block(j, k));
            double* inverse = &inverse_[static_cast<std::size_t>(n * j)];
            if (j < i)
                divide_by_transpose(at, block(j, j), inverse);
            else
                factor_diagonal(at, inverse);
        }
    }
}

void SkylineCholesky::solve(std::span<double> x) const {
    const int rows = static_cast<int>(first_.size());
    ASSERT(x.size() == first_.size() * n);
    for (int i = 0; i < rows; i++) {
        const auto at = static_cast<std::size_t>(n * i);
        Six own = load_six(&x[at]);
        for (int k = first_[static_cast<std::size_t>(i)]; k < i; k++) {
            const double *l = block(i, k), *other = &x[static_cast<std::size_t>(n * k)];
            for (int c = 0; c < n; c++) own = own - load_six(l + n * c) * other[c];
        }
        const double* l = block(i, i);
        double value[n];
        store_six(value, own);
        for (int c = 0; c < n; c++) {
            value[c] *= inverse_[at + static_cast<std::size_t>(c)];
            for (int r = c + 1; r < n; r++) value[r] -= l[n * c + r] * value[c];
        }
        std::copy(value, value + n, &x[at]);
    }
    for (int i = rows - 1; i >= 0; i--) {
        const auto at = static_cast<std::size_t>(n * i);
        double* value = &x[at];
        const double* l = block(i, i);
        for (int r = n - 1; r >= 0; r--) {
            for (int c = r + 1; c < n; c++) value[r] -= l[n * r + c] * value[c];
            value[r] *= inverse_[at + static_cast<std::size_t>(r)];
        }
        const Six own = load_six(value);
        for (int k = first_[static_cast<std::size_t>(i)]; k < i; k++) {
            const double* up = block(i, k);
            double* other = &x[static_cast<std::size_t>(n * k)];
            for (int c = 0; c < n; c++) other[c] -= dot6(load_six(up + n * c), own);
        }
    }
}

}  // namespace jostle::physics
