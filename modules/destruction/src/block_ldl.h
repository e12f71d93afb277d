// SPDX-License-Identifier: MIT
//
// Solves K x = f for a sparse symmetric matrix of 6 x 6 blocks by L D L^T factorization with
// minimum degree ordering (A. George, J. W. H. Liu, "The Evolution of the Minimum Degree Ordering
// Algorithm", 1989). The order depends only on the sparsity pattern, so equal matrices give
// bit-identical results.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace jostle::modules::destruction_detail {

using Block = std::array<double, 36>;  // row-major
using Block6 = std::array<double, 6>;

struct BlockMatrix {
    struct OffDiagonalBlock {
        std::uint32_t row = 0, column = 0;  // row > column: the lower triangle
        Block block = {};
    };
    std::vector<Block> diagonal;
    std::vector<OffDiagonalBlock> off_diagonal;  // entries at the same position are summed
};

class BlockFactor {
public:
    explicit BlockFactor(const BlockMatrix& matrix);
    // Components along directions without stiffness stay 0.
    void solve(std::span<Block6> x) const;
    // Number of block products of the factorization.
    std::uint64_t work() const { return work_; }
    std::size_t size() const { return order_.size(); }

private:
    void order_by_degree(const BlockMatrix& matrix);
    void scatter(const BlockMatrix& matrix);
    void eliminate(std::size_t k);
    Block& at(std::uint32_t row, std::uint32_t column);

    std::vector<std::uint32_t> order_, rank_;       // node at each position, position of each node
    std::vector<std::vector<std::uint32_t>> rows_;  // per column: row positions, ascending
    std::vector<std::vector<Block>> blocks_;        // parallel to rows_
    std::vector<Block> diagonal_;                   // by position; inverted after elimination
    std::uint64_t work_ = 0;
};

}  // namespace jostle::modules::destruction_detail
