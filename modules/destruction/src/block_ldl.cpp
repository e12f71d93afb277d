// SPDX-License-Identifier: MIT
#include "modules/destruction/src/block_ldl.h"

#include <algorithm>
#include <set>
#include <utility>

namespace jostle::modules::destruction_detail {

namespace {

// Subtracts a x^T b, with x^T given transposed: to[r][c] -= a[r][m] * turned[m][c].
void subtract_product(Block& to, const Block& a, const Block& turned) {
    for (std::size_t r = 0; r < 6; r++)
        for (std::size_t m = 0; m < 6; m++) {
            const double s = a[6 * r + m];
            for (std::size_t c = 0; c < 6; c++) to[6 * r + c] -= s * turned[6 * m + c];
        }
}

Block product(const Block& a, const Block& b) {
    Block to = {};
    for (std::size_t r = 0; r < 6; r++)
        for (std::size_t m = 0; m < 6; m++)
            for (std::size_t c = 0; c < 6; c++) to[6 * r + c] += a[6 * r + m] * b[6 * m + c];
    return to;
}

Block turned(const Block& a) {
    Block to;
    for (std::size_t r = 0; r < 6; r++)
        for (std::size_t c = 0; c < 6; c++) to[6 * c + r] = a[6 * r + c];
    return to;
}

// Gauss-Jordan elimination without pivoting: the block is positive semidefinite. A pivot that is
// negligible relative to the original diagonal is a direction without stiffness; its row and column
// become 0.
Block inverted(Block a) {
    Block6 before;
    for (std::size_t k = 0; k < 6; k++) before[k] = a[7 * k];
    for (std::size_t k = 0; k < 6; k++) {
        const double pivot = a[7 * k];
        const bool resists = pivot > 1e-13 * before[k] && pivot > 1e-300;
        const double s = resists ? 1 / pivot : 0;
        for (std::size_t c = 0; c < 6; c++)
            if (c != k) a[6 * k + c] *= s;
        for (std::size_t r = 0; r < 6; r++) {
            if (r == k) continue;
            const double factor = a[6 * r + k];
            for (std::size_t c = 0; c < 6; c++)
                if (c != k) a[6 * r + c] -= factor * a[6 * k + c];
            a[6 * r + k] = -factor * s;
        }
        a[7 * k] = s;
    }
    return a;
}

void subtract_product(Block6& to, const Block& a, const Block6& x) {
    for (std::size_t r = 0; r < 6; r++)
        for (std::size_t c = 0; c < 6; c++) to[r] -= a[6 * r + c] * x[c];
}
void subtract_turned_product(Block6& to, const Block& a, const Block6& x) {
    for (std::size_t r = 0; r < 6; r++)
        for (std::size_t c = 0; c < 6; c++) to[c] -= a[6 * r + c] * x[r];
}

}  // namespace

BlockFactor::BlockFactor(const BlockMatrix& matrix) {
    order_by_degree(matrix);
    scatter(matrix);
    for (std::size_t k = 0; k < order_.size(); k++) eliminate(k);
}

// Symbolic elimination on the graph: the neighbours of an eliminated node become neighbours of each
// other and are the rows of its column.
void BlockFactor::order_by_degree(const BlockMatrix& matrix) {
    const std::size_t n = matrix.diagonal.size();
    std::vector<std::vector<std::uint32_t>> near(n);
    for (const BlockMatrix::OffDiagonalBlock& link : matrix.off_diagonal) {
        near[link.row].push_back(link.column);
        near[link.column].push_back(link.row);
    }
    std::set<std::pair<std::size_t, std::uint32_t>> waiting;
    for (std::uint32_t k = 0; k < n; k++) {
        std::sort(near[k].begin(), near[k].end());
        near[k].erase(std::unique(near[k].begin(), near[k].end()), near[k].end());
        waiting.emplace(near[k].size(), k);
    }
    rank_.resize(n);
    std::vector<std::uint32_t> merged;
    while (!waiting.empty()) {
        const std::uint32_t out = waiting.begin()->second;
        waiting.erase(waiting.begin());
        rank_[out] = static_cast<std::uint32_t>(order_.size());
        order_.push_back(out);
        for (const std::uint32_t u : near[out]) {
            waiting.erase({near[u].size(), u});
            merged.clear();
            std::set_union(near[u].begin(), near[u].end(), near[out].begin(), near[out].end(),
                           std::back_inserter(merged));
            std::erase_if(merged, [&](std::uint32_t w) { return w == u || w == out; });
            near[u] = merged;
            waiting.emplace(near[u].size(), u);
        }
        rows_.push_back(std::move(near[out]));
    }
    for (auto& rows : rows_) {
        for (std::uint32_t& row : rows) row = rank_[row];
        std::sort(rows.begin(), rows.end());
    }
}

Block& BlockFactor::at(std::uint32_t row, std::uint32_t column) {
    const auto& rows = rows_[column];
    const auto found = std::lower_bound(rows.begin(), rows.end(), row);
    return blocks_[column][static_cast<std::size_t>(found - rows.begin())];
}

void BlockFactor::scatter(const BlockMatrix& matrix) {
    const std::size_t n = order_.size();
    diagonal_.resize(n);
    blocks_.resize(n);
    for (std::size_t k = 0; k < n; k++) {
        diagonal_[k] = matrix.diagonal[order_[k]];
        blocks_[k].assign(rows_[k].size(), Block{});
    }
    for (const BlockMatrix::OffDiagonalBlock& link : matrix.off_diagonal) {
        const std::uint32_t row = rank_[link.row], column = rank_[link.column];
        Block& to = row > column ? at(row, column) : at(column, row);
        const Block block = row > column ? link.block : turned(link.block);
        for (std::size_t k = 0; k < 36; k++) to[k] += block[k];
    }
}

// Updates all later columns: A_ij -= L_ik A_jk^T. The rows of this column also exist in the updated
// columns, in the same order.
void BlockFactor::eliminate(std::size_t k) {
    diagonal_[k] = inverted(diagonal_[k]);
    const std::vector<std::uint32_t>& rows = rows_[k];
    std::vector<Block>& column = blocks_[k];
    std::vector<Block> low(column.size());
    for (std::size_t i = 0; i < rows.size(); i++) low[i] = product(column[i], diagonal_[k]);
    for (std::size_t j = 0; j < rows.size(); j++) {
        const std::uint32_t to = rows[j];
        const Block across = turned(column[j]);
        subtract_product(diagonal_[to], low[j], across);
        std::size_t slot = 0;
        for (std::size_t i = j + 1; i < rows.size(); i++) {
            while (rows_[to][slot] != rows[i]) slot++;
            subtract_product(blocks_[to][slot], low[i], across);
        }
    }
    work_ += rows.size() * (rows.size() + 3) / 2 + 1;
    column = std::move(low);
}

void BlockFactor::solve(std::span<Block6> x) const {
    const std::size_t n = order_.size();
    for (std::size_t k = 0; k < n; k++)
        for (std::size_t i = 0; i < rows_[k].size(); i++)
            subtract_product(x[order_[rows_[k][i]]], blocks_[k][i], x[order_[k]]);
    for (std::size_t k = n; k-- > 0;) {
        Block6 own = {};
        subtract_product(own, diagonal_[k], x[order_[k]]);
        for (double& value : own) value = -value;
        for (std::size_t i = 0; i < rows_[k].size(); i++)
            subtract_turned_product(own, blocks_[k][i], x[order_[rows_[k][i]]]);
        x[order_[k]] = own;
    }
}

}  // namespace jostle::modules::destruction_detail
