// SPDX-License-Identifier: MIT
//
// K x = f for a symmetric matrix of 6 x 6 blocks of which few are there: L D L^T, eliminated in the
// order of least degree (George, Liu, "The Evolution of the Minimum Degree Ordering Algorithm",
// 1989). The order follows from the pattern alone, so the same matrix gives the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace jostle::modules::destruction_detail {

using Block = std::array<double, 36>;  // by rows
using Block6 = std::array<double, 6>;

struct BlockMatrix {
    struct OffDiagonalBlock {
        std::uint32_t row = 0, column = 0;  // row > column: the lower half
        Block block = {};
    };
    std::vector<Block> diagonal;
    std::vector<OffDiagonalBlock> off_diagonal;  // several of a place add up
};

class BlockFactor {
public:
    explicit BlockFactor(const BlockMatrix& matrix);
    // Directions in which the matrix gives no resistance stay at 0.
    void solve(std::span<Block6> x) const;
    // Products of blocks that the factor took.
    std::uint64_t work() const { return work_; }
    std::size_t size() const { return order_.size(); }

private:
    void order_by_degree(const BlockMatrix& matrix);
    void scatter(const BlockMatrix& matrix);
    void eliminate(std::size_t k);
    Block& at(std::uint32_t row, std::uint32_t column);

    std::vector<std::uint32_t> order_, rank_;       // node at each place, place of each node
    std::vector<std::vector<std::uint32_t>> rows_;  // of each column, by place, ascending
    std::vector<std::vector<Block>> blocks_;        // beside rows_
    std::vector<Block> diagonal_;                   // by place; inverted once eliminated
    std::uint64_t work_ = 0;
};

}  // namespace jostle::modules::destruction_detail
