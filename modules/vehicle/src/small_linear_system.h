// SPDX-License-Identifier: MIT
//
// Solves small symmetric positive definite systems by an L D L^T factorization (Golub, Van Loan,
// "Matrix Computations", 4.1.2).
#pragma once

#include <array>
#include <cstddef>

namespace jostle::modules::vehicle_detail {

template <std::size_t most>
struct SmallLinearSystem {
    std::array<std::array<double, most>, most> a;  // the lower triangle is input and is overwritten
    std::array<double, most> b;                    // right-hand side; receives the solution
    std::size_t size = 0;

    void clear(std::size_t unknowns) {
        size = unknowns;
        for (std::size_t i = 0; i < size; i++) {
            b[i] = 0;
            for (std::size_t j = 0; j <= i; j++) a[i][j] = 0;
        }
    }

    void solve() {
        std::array<double, most> inverse, scaled;
        for (std::size_t i = 0; i < size; i++) {
            double pivot = a[i][i];
            for (std::size_t j = 0; j < i; j++) {
                double sum = a[i][j];
                for (std::size_t k = 0; k < j; k++) sum -= scaled[k] * a[j][k];
                scaled[j] = sum;  // L(i, j) D(j)
                a[i][j] = sum * inverse[j];
                pivot -= sum * a[i][j];
            }
            inverse[i] = 1 / pivot;
            for (std::size_t j = 0; j < i; j++) b[i] -= a[i][j] * b[j];
        }
        for (std::size_t i = size; i-- > 0;) {
            b[i] *= inverse[i];
            for (std::size_t j = i + 1; j < size; j++) b[i] -= a[j][i] * b[j];
        }
    }
};

}  // namespace jostle::modules::vehicle_detail
