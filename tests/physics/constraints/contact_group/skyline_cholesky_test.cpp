// SPDX-License-Identifier: MIT
#include "physics/src/constraints/contact_group/skyline_cholesky.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using physics::SkylineCholesky;

constexpr std::size_t n = SkylineCholesky::size;

// I + sum of g g^T over random rows of the given pairs of blocks; `whole`: the same as a full
// matrix.
struct Example {
    SkylineCholesky matrix;
    std::vector<double> whole;
    std::size_t size = 0;
};
Example make(const std::vector<int>& first, const std::vector<std::pair<int, int>>& pairs) {
    Example example;
    example.size = n * first.size();
    example.whole.assign(example.size * example.size, 0);
    example.matrix.set_pattern(first);
    example.matrix.set_identity();
    for (std::size_t i = 0; i < example.size; i++) example.whole[(example.size + 1) * i] = 1;
    Random random(3);
    for (const auto& [i, j] : pairs)
        for (int row = 0; row < 4; row++) {
            double g[2][n];
            for (auto& side : g)
                for (double& value : side) value = random.in(-1, 1);
            const int at[] = {i, j};
            for (int a = 0; a < 2; a++)
                for (int b = 0; b < 2; b++)
                    for (std::size_t r = 0; r < n; r++)
                        for (std::size_t c = 0; c < n; c++) {
                            const double value = g[a][r] * g[b][c];
                            if (at[a] >= at[b])
                                example.matrix.block(at[a], at[b])[n * c + r] += value;
                            example.whole[(n * static_cast<std::size_t>(at[a]) + r) * example.size +
                                          n * static_cast<std::size_t>(at[b]) + c] += value;
                        }
        }
    return example;
}

double worst_residual(Example& example) {
    std::vector<double> x(example.size), right(example.size);
    Random random(5);
    for (std::size_t i = 0; i < x.size(); i++) right[i] = x[i] = random.in(-1, 1);
    example.matrix.factor();
    example.matrix.solve(x);
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); i++) {
        double sum = -right[i];
        for (std::size_t j = 0; j < x.size(); j++)
            sum += example.whole[example.size * i + j] * x[j];
        worst = std::max(worst, std::abs(sum));
    }
    return worst;
}

TEST(SkylineCholesky, solves_a_chain) {
    Example example = make({0, 0, 1, 2, 3}, {{1, 0}, {2, 1}, {3, 2}, {4, 3}});
    EXPECT_LT(worst_residual(example), 1e-12);
}

TEST(SkylineCholesky, solves_a_ring_whose_last_row_is_full) {
    Example example = make({0, 0, 1, 2, 0}, {{1, 0}, {2, 1}, {3, 2}, {4, 3}, {4, 0}});
    EXPECT_LT(worst_residual(example), 1e-12);
}

TEST(SkylineCholesky, pivots_that_rounding_spoils_are_at_least_one) {
    SkylineCholesky matrix;
    const std::vector<int> first{0, 0};
    matrix.set_pattern(first);
    matrix.set_identity();
    // 1 + 1e20 twice and coupled by -1e20: the identity is lost.
    matrix.block(0, 0)[0] = matrix.block(1, 1)[0] = 1e20;
    matrix.block(1, 0)[0] = -1e20;
    matrix.factor();
    std::vector<double> x(2 * n);
    x[0] = x[n] = 1;
    matrix.solve(x);
    EXPECT_NEAR(x[0], 2, 1e-6) << "both together move as if only the identities held them";
    EXPECT_NEAR(x[n], 2, 1e-6);
}

}  // namespace
}  // namespace jostle::test
