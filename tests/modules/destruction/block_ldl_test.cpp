// SPDX-License-Identifier: MIT
#include "modules/destruction/src/block_ldl.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jostle::modules::destruction_detail {
namespace {

// A grid of blocks: adjacent ones are coupled, and each has a small support.
BlockMatrix net(std::uint32_t wide, std::uint32_t high, double held) {
    BlockMatrix matrix;
    matrix.diagonal.assign(wide * high, Block{});
    const auto link = [&](std::uint32_t a, std::uint32_t b) {
        BlockMatrix::OffDiagonalBlock made{.row = b, .column = a};
        for (std::size_t k = 0; k < 6; k++) {
            const double s = 1 + 0.1 * static_cast<double>(k + a % 3);
            made.block[7 * k] = -s;
            matrix.diagonal[a][7 * k] += s;
            matrix.diagonal[b][7 * k] += s;
        }
        made.block[1] = 0.1;  // not symmetric
        matrix.off_diagonal.push_back(made);
    };
    for (Block& block : matrix.diagonal)
        for (std::size_t k = 0; k < 6; k++) block[7 * k] += held;
    for (std::uint32_t y = 0; y < high; y++)
        for (std::uint32_t x = 0; x < wide; x++) {
            if (x + 1 < wide) link(y * wide + x, y * wide + x + 1);
            if (y + 1 < high) link(y * wide + x, (y + 1) * wide + x);
        }
    return matrix;
}

std::vector<Block6> times(const BlockMatrix& m, const std::vector<Block6>& x) {
    std::vector<Block6> f(x.size(), Block6{});
    const auto add = [](Block6& to, const Block& b, const Block6& v, bool turned) {
        for (std::size_t r = 0; r < 6; r++)
            for (std::size_t c = 0; c < 6; c++)
                to[r] += (turned ? b[6 * c + r] : b[6 * r + c]) * v[c];
    };
    for (std::size_t k = 0; k < x.size(); k++) add(f[k], m.diagonal[k], x[k], false);
    for (const BlockMatrix::OffDiagonalBlock& link : m.off_diagonal) {
        add(f[link.row], link.block, x[link.column], false);
        add(f[link.column], link.block, x[link.row], true);
    }
    return f;
}

TEST(BlockLdl, solves_a_grid_matrix) {
    const BlockMatrix matrix = net(20, 15, 0.5);
    std::vector<Block6> x(matrix.diagonal.size());
    for (std::size_t k = 0; k < x.size(); k++)
        for (std::size_t c = 0; c < 6; c++) x[k][c] = static_cast<double>((k * 7 + c * 3) % 11) - 5;
    std::vector<Block6> solved = times(matrix, x);
    const BlockFactor factor(matrix);
    factor.solve(solved);
    double worst = 0;
    for (std::size_t k = 0; k < x.size(); k++)
        for (std::size_t c = 0; c < 6; c++)
            worst = std::max(worst, std::abs(solved[k][c] - x[k][c]));
    EXPECT_LT(worst, 1e-11);
}

// Minimum degree ordering causes much less fill-in than row ordering: 30 n log n compared with
// n^1.5.
TEST(BlockLdl, grid_matrix_has_little_fill_in) {
    const BlockFactor factor(net(40, 40, 1));
    RecordProperty("work", static_cast<int>(factor.work()));
    EXPECT_LT(factor.work(), 1600u * 40 * 41 / 2 / 4);
}

TEST(BlockLdl, unconstrained_directions_stay_zero) {
    BlockMatrix matrix = net(3, 1, 0);  // without support
    matrix.off_diagonal[0].block[1] = matrix.off_diagonal[1].block[1] = 0;
    std::vector<Block6> x(3, Block6{});
    x[0][0] = 1, x[2][0] = -1;
    BlockFactor(matrix).solve(x);
    for (const Block6& moved : x)
        for (const double value : moved) EXPECT_TRUE(std::abs(value) < 10) << value;
}

}  // namespace
}  // namespace jostle::modules::destruction_detail
