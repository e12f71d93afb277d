// SPDX-License-Identifier: MIT
//
// Cholesky factorization of the identity plus a sparse positive semidefinite matrix of 6 x 6 blocks
// in skyline storage: each block row holds the blocks from its first one to the diagonal. The
// matrix of a stack in the order of its bodies has two blocks per row, so the work is linear in the
// bodies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/base/check.h"

namespace jostle::physics {

class SkylineCholesky {
public:
    static constexpr int size = 6;  // of a block

    // Sets the pattern. first[i] <= i: the first block of block row i.
    void set_pattern(std::span<const int> first);
    // Products of two blocks in a factorization.
    std::int64_t products() const { return products_; }
    void set_identity();
    // The block (i, j), first[i] <= j <= i, column by column. Of the diagonal blocks only the lower
    // triangle is read.
    double* block(int i, int j) { return values_.data() + offset(i, j); }

    // Pivots are clamped to at least 1, their lower bound in exact arithmetic: beside large
    // elements, rounding may lose the identity.
    void factor();
    // Replaces x by the solution. x has `size` elements per block row.
    void solve(std::span<double> x) const;

private:
    std::size_t offset(int i, int j) const {
        const auto row = static_cast<std::size_t>(i);
        ASSERT(row < first_.size() && first_[row] <= j && j <= i);
        return begin_[row] + static_cast<std::size_t>(j - first_[row]) * (size * size);
    }
    const double* block(int i, int j) const { return values_.data() + offset(i, j); }

    std::int64_t products_ = 0;
    std::vector<int> first_;
    std::vector<std::size_t> begin_;  // of block rows in values_
    std::vector<double> values_;
    std::vector<double> inverse_;  // of the elements on the diagonal of the factor
};

}  // namespace jostle::physics
