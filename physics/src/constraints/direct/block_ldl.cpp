// SPDX-License-Identifier: MIT
#include "jostle/physics/block_ldl.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"
#include "physics/src/constraints/direct/joint_net.h"

namespace jostle::physics {
namespace {

constexpr int max_block_rows = BlockLdl::max_rows;

// Inverts a pivot block of n rows by its own L D L^T. `original`: its diagonal before the
// elimination. Returns the number of dependent rows.
// kRows: n, 0 if it is not known.
template <int kRows>
int invert_block(const double* block, int rows, const double* original, double dependent,
                 double* inverse) {
    const int n = kRows != 0 ? kRows : rows;
    // Below the diagonals; the rest is not used.
    double lower[max_block_rows][max_block_rows], pivot[max_block_rows], reciprocal[max_block_rows],
        x[max_block_rows][max_block_rows];
    ASSERT(n >= 1 && n <= max_block_rows);
    int skipped_rows = 0;
    for (int j = 0; j < n; j++) {
        double d = block[j * n + j];
        for (int k = 0; k < j; k++) d -= lower[j][k] * lower[j][k] * pivot[k];
        const bool bad = !(d > dependent * original[j]);
        skipped_rows += bad && original[j] > 0 ? 1 : 0;
        pivot[j] = bad ? 0 : d;
        reciprocal[j] = bad ? 0 : 1 / d;
        for (int i = j + 1; i < n; i++) {
            double s = block[i * n + j];
            for (int k = 0; k < j; k++) s -= lower[i][k] * lower[j][k] * pivot[k];
            lower[i][j] = s * reciprocal[j];
        }
    }
    for (int c = 0; c < n; c++) {
        x[c][c] = 1;
        for (int i = c + 1; i < n; i++) {
            double s = 0;
            for (int k = c; k < i; k++) s -= lower[i][k] * x[k][c];
            x[i][c] = s;
        }
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++) {
            double s = 0;
            for (int k = i; k < n; k++) s += x[k][i] * x[k][j] * reciprocal[k];
            inverse[i * n + j] = inverse[j * n + i] = s;
        }
    return skipped_rows;
}

int invert_pivot(const double* block, int n, const double* original, double dependent,
                 double* inverse) {
    const auto invert = n == 3   ? invert_block<3>
                        : n == 5 ? invert_block<5>
                        : n == 6 ? invert_block<6>
                                 : invert_block<0>;
    return invert(block, n, original, dependent, inverse);
}

// The same for a negative definite block.
int invert_negative(const double* block, int n, const double* original, double dependent,
                    double* inverse) {
    double negated[max_block_rows * max_block_rows];
    for (int i = 0; i < n * n; i++) negated[i] = -block[i];
    const int skipped_rows = invert_pivot(negated, n, original, dependent, inverse);
    for (int i = 0; i < n * n; i++) inverse[i] = -inverse[i];
    return skipped_rows;
}

// Inverts a block of three rows by cofactors if the rows are far from dependent.
bool invert_three(const double* m, const double* original, double* inverse) {
    const double a = m[0], b = m[3], c = m[6], d = m[4], e = m[7], f = m[8];
    const double m0 = d * f - e * e, m1 = c * e - b * f, m2 = b * e - c * d;
    const double determinant = a * m0 + b * m1 + c * m2;
    if (!(determinant > 1e-7 * original[0] * original[1] * original[2] && a > 0 && m0 > 0))
        return false;
    const double s = 1 / determinant;
    inverse[0] = m0 * s;
    inverse[1] = inverse[3] = m1 * s;
    inverse[2] = inverse[6] = m2 * s;
    inverse[4] = (a * f - c * c) * s;
    inverse[5] = inverse[7] = (b * c - a * e) * s;
    inverse[8] = (a * d - b * b) * s;
    return true;
}

}  // namespace

void BlockLdl::clear() {
    std::fill(values_.begin(), values_.end(), 0.0);
}

namespace {

// The rows of two blocks of a column with nk pivots: to -= lower column. kPivots, kColumns: nk and
// nj, 0 if they are not known.
template <int kPivots, int kColumns>
void subtract_product(const double* lower, const double* column, int ni, int nj, int nk,
                      double* to) {
    if (kPivots != 0) nk = kPivots;
    if (kColumns != 0) nj = kColumns;
    for (int r = 0; r < ni; r++) {
        double s[kColumns != 0 ? kColumns : max_block_rows] = {};
        for (int t = 0; t < nk; t++)
            for (int c = 0; c < nj; c++) s[c] += lower[r * nk + t] * column[t * nj + c];
        for (int c = 0; c < nj; c++) to[r * nj + c] -= s[c];
    }
}

template <int kPivots>
auto product_of(int nj) {
    return nj == 3   ? subtract_product<kPivots, 3>
           : nj == 5 ? subtract_product<kPivots, 5>
           : nj == 6 ? subtract_product<kPivots, 6>
                     : subtract_product<kPivots, 0>;
}

}  // namespace

// Right-looking. kPivots: rows of the node, 0 if they are not known. kSame: all nodes have as many.
template <int kPivots, bool kSame>
int BlockLdl::factor_column(int k, double dependent) {
    static_assert(kPivots != 0 || !kSame);
    const int nk = kPivots != 0 ? kPivots : rows_[as_index(k)];
    double* const pivot = values_.data() + diagonal_[as_index(k)];
    double* const inverse = inverse_.data() + as_index(k) * block_values_;
    const double* const original = original_diagonal_.data() + begin_[as_index(k)];
    int skipped_rows = 0;
    if (!negative_.empty() && negative_[as_index(k)] != 0)
        skipped_rows = invert_negative(pivot, nk, original, dependent, inverse);
    else if (!(kPivots == 3 && kSame) || !invert_three(pivot, original, inverse))
        skipped_rows = invert_pivot(pivot, nk, original, dependent, inverse);
    const int first = first_below_[as_index(k)], count = first_below_[as_index(k) + 1] - first;
    if (count == 0) return skipped_rows;
    ASSERT(count > 0);
    // The column is copied, each block transposed, so that the sums of a row of the result are
    // independent in the innermost loop. L = column D^-1 overwrites it.
    column_at_.resize(as_index(count));
    std::size_t size = 0;
    for (int i = 0; i < count; i++) {
        column_at_[as_index(i)] = static_cast<int>(size);
        size += as_index(rows_[as_index(below_[as_index(first + i)].position)] * nk);
    }
    if (column_.size() < size) column_.resize(size);
    for (int i = 0; i < count; i++) {
        const Below& below = below_[as_index(first + i)];
        const int ni = kSame ? kPivots : rows_[as_index(below.position)];
        double* const lower = values_.data() + below.at;
        double* const column = column_.data() + column_at_[as_index(i)];
        for (int r = 0; r < ni; r++) {
            double s[kPivots != 0 ? kPivots : max_block_rows] = {};
            for (int t = 0; t < nk; t++) {
                const double value = column[t * ni + r] = lower[r * nk + t];
                for (int c = 0; c < nk; c++) s[c] += value * inverse[t * nk + c];
            }
            std::copy(s, s + nk, lower + r * nk);
        }
    }
    for (int u = first_update_[as_index(k)]; u < first_update_[as_index(k) + 1]; u++) {
        const Update& update = updates_[as_index(u)];
        ASSERT(update.i >= update.j && update.j >= 0 && update.i < count);
        const Below &bi = below_[as_index(first + update.i)],
                    &bj = below_[as_index(first + update.j)];
        const double* const lower = values_.data() + bi.at;
        const double* const column = column_.data() + column_at_[as_index(update.j)];
        double* const to = values_.data() + update.at;
        if constexpr (kSame) {
            subtract_product<kPivots, kPivots>(lower, column, kPivots, kPivots, kPivots, to);
        } else {
            const int nj = rows_[as_index(bj.position)];
            product_of<kPivots>(nj)(lower, column, rows_[as_index(bi.position)], nj, nk, to);
        }
    }
    return skipped_rows;
}

template <int kRows>
int BlockLdl::factor_columns(double dependent) {
    int skipped_rows = 0;
    const int n = nodes();
    ASSERT(first_below_.size() == as_index(n) + 1 && first_update_.size() == as_index(n) + 1);
    for (int k = 0; k < n; k++) {
        if constexpr (kRows != 0) {
            skipped_rows += factor_column<kRows, true>(k, dependent);
        } else {
            const int rows = rows_[as_index(k)];
            skipped_rows += rows == 3   ? factor_column<3, false>(k, dependent)
                            : rows == 5 ? factor_column<5, false>(k, dependent)
                            : rows == 6 ? factor_column<6, false>(k, dependent)
                                        : factor_column<0, false>(k, dependent);
        }
    }
    return skipped_rows;
}

int BlockLdl::factor(double dependent) {
    ASSERT(original_diagonal_.size() == as_index(rows()));
    for (int k = 0; k < nodes(); k++)
        for (int i = 0; i < rows_[as_index(k)]; i++)
            original_diagonal_[as_index(begin_[as_index(k)] + i)] =
                absolute(values_[as_index(diagonal_[as_index(k)] + i * rows_[as_index(k)] + i)]);
    return same_rows_ == 3   ? factor_columns<3>(dependent)
           : same_rows_ == 5 ? factor_columns<5>(dependent)
           : same_rows_ == 6 ? factor_columns<6>(dependent)
                             : factor_columns<0>(dependent);
}

// kPivots, kSame: see factor_column().
template <int kPivots, bool kSame>
void BlockLdl::eliminate_column(int k, double* x) const {
    const int nk = kPivots != 0 ? kPivots : rows_[as_index(k)];
    const double* const xk = x + begin_[as_index(k)];
    for (int b = first_below_[as_index(k)]; b < first_below_[as_index(k) + 1]; b++) {
        const Below& below = below_[as_index(b)];
        const int ni = kSame ? kPivots : rows_[as_index(below.position)];
        const double* const lower = values_.data() + below.at;
        double* const xi = x + begin_[as_index(below.position)];
        for (int r = 0; r < ni; r++) {
            double s = 0;
            for (int t = 0; t < nk; t++) s += lower[r * nk + t] * xk[t];
            xi[r] -= s;
        }
    }
}

template <int kPivots, bool kSame>
void BlockLdl::substitute_column(int k, double* x) const {
    const int nk = kPivots != 0 ? kPivots : rows_[as_index(k)];
    const double* const inverse = inverse_.data() + as_index(k) * block_values_;
    double* const xk = x + begin_[as_index(k)];
    double y[max_block_rows];
    for (int r = 0; r < nk; r++) {
        double s = 0;
        for (int t = 0; t < nk; t++) s += inverse[r * nk + t] * xk[t];
        y[r] = s;
    }
    for (int b = first_below_[as_index(k)]; b < first_below_[as_index(k) + 1]; b++) {
        const Below& below = below_[as_index(b)];
        const int ni = kSame ? kPivots : rows_[as_index(below.position)];
        const double* const lower = values_.data() + below.at;
        const double* const xi = x + begin_[as_index(below.position)];
        for (int r = 0; r < ni; r++)
            for (int t = 0; t < nk; t++) y[t] -= lower[r * nk + t] * xi[r];
    }
    for (int r = 0; r < nk; r++) xk[r] = y[r];
}

template <int kRows>
void BlockLdl::solve_columns(double* x) const {
    const int n = nodes();
    if constexpr (kRows != 0) {
        for (int k = 0; k < n; k++) eliminate_column<kRows, true>(k, x);
        for (int k = n - 1; k >= 0; k--) substitute_column<kRows, true>(k, x);
        return;
    }
    for (int k = 0; k < n; k++) {
        const int rows = rows_[as_index(k)];
        rows == 3   ? eliminate_column<3, false>(k, x)
        : rows == 5 ? eliminate_column<5, false>(k, x)
        : rows == 6 ? eliminate_column<6, false>(k, x)
                    : eliminate_column<0, false>(k, x);
    }
    for (int k = n - 1; k >= 0; k--) {
        const int rows = rows_[as_index(k)];
        rows == 3   ? substitute_column<3, false>(k, x)
        : rows == 5 ? substitute_column<5, false>(k, x)
        : rows == 6 ? substitute_column<6, false>(k, x)
                    : substitute_column<0, false>(k, x);
    }
}

void BlockLdl::solve(std::span<double> x) const {
    ASSERT(static_cast<int>(x.size()) == rows());
    if (same_rows_ == 3)
        solve_columns<3>(x.data());
    else if (same_rows_ == 5)
        solve_columns<5>(x.data());
    else if (same_rows_ == 6)
        solve_columns<6>(x.data());
    else
        solve_columns<0>(x.data());
}

}  // namespace jostle::physics
