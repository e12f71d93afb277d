// SPDX-License-Identifier: MIT
//
// The block factorisation against Gauss elimination of the same matrix, written out.
#include "physics/src/constraints/direct/joint_net.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace jostle::test {
namespace {
using physics::BlockLdl;

using Dense = std::vector<std::vector<double>>;

// With pivots by size; what is left without one is zero.
std::vector<double> solve_dense(Dense m, std::vector<double> x) {
    const std::size_t n = x.size();
    for (std::size_t k = 0; k < n; k++) {
        std::size_t best = k;
        for (std::size_t i = k; i < n; i++)
            if (std::abs(m[i][k]) > std::abs(m[best][k])) best = i;
        std::swap(m[k], m[best]);
        std::swap(x[k], x[best]);
        for (std::size_t i = k + 1; i < n; i++) {
            const double f = m[i][k] / m[k][k];
            for (std::size_t c = k; c < n; c++) m[i][c] -= f * m[k][c];
            x[i] -= f * x[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t c = k + 1; c < n; c++) x[k] -= m[k][c] * x[c];
        x[k] /= m[k][k];
    }
    return x;
}

// J J^T of random rows: nodes share columns where an edge joins them.
struct Problem {
    std::vector<int> rows;
    std::vector<BlockLdl::Edge> edges;
    std::vector<std::vector<std::vector<double>>> jacobian;  // by node and row: all columns

    Problem(std::vector<int> rows_of_node, std::vector<BlockLdl::Edge> pairs, std::mt19937& random)
        : rows(std::move(rows_of_node)), edges(std::move(pairs)) {
        std::uniform_real_distribution<double> any(-1, 1);
        const std::size_t bodies = edges.size() + rows.size();
        jacobian.resize(rows.size());
        for (std::size_t node = 0; node < rows.size(); node++)
            for (int r = 0; r < rows[node]; r++) {
                std::vector<double> row(bodies * 9);
                const auto fill = [&](std::size_t body) {
                    for (std::size_t c = 0; c < 9; c++) row[body * 9 + c] = any(random);
                };
                fill(edges.size() + node);
                for (std::size_t e = 0; e < edges.size(); e++)
                    if (edges[e].first == static_cast<int>(node) ||
                        edges[e].second == static_cast<int>(node))
                        fill(e);
                jacobian[node].push_back(row);
            }
    }
    double product(std::size_t a, int i, std::size_t b, int k) const {
        double s = 0;
        const auto &x = jacobian[a][static_cast<std::size_t>(i)],
                   &y = jacobian[b][static_cast<std::size_t>(k)];
        for (std::size_t c = 0; c < x.size(); c++) s += x[c] * y[c];
        return s;
    }
    void write(BlockLdl& ldl, Dense& dense) const {
        const auto size = static_cast<std::size_t>(ldl.rows());
        dense.assign(size, std::vector<double>(size));
        ldl.clear();
        const auto put = [&](int a, int b) {
            const int later = ldl.is_later(a, b) ? a : b, sooner = later == a ? b : a;
            const int columns = rows[static_cast<std::size_t>(sooner)];
            for (int i = 0; i < rows[static_cast<std::size_t>(later)]; i++)
                for (int k = 0; k < columns; k++) {
                    const double x = product(static_cast<std::size_t>(later), i,
                                             static_cast<std::size_t>(sooner), k);
                    ldl.values()[static_cast<std::size_t>(ldl.block_at(later, sooner) +
                                                          i * columns + k)] = x;
                    const auto r = static_cast<std::size_t>(ldl.row_of(later) + i);
                    const auto c = static_cast<std::size_t>(ldl.row_of(sooner) + k);
                    dense[r][c] = dense[c][r] = x;
                }
        };
        for (int node = 0; node < ldl.nodes(); node++) put(node, node);
        for (const auto& [a, b] : edges) put(a, b);
    }
};

std::vector<BlockLdl::Edge> random_edges(int nodes, int more, std::mt19937& random) {
    std::vector<BlockLdl::Edge> edges;
    for (int k = 1; k < nodes; k++) edges.push_back({k, static_cast<int>(random() % k)});  // a tree
    for (int k = 0; k < more; k++) {
        const int a = static_cast<int>(random() % nodes), b = static_cast<int>(random() % nodes);
        bool there = a == b;
        for (const auto& [x, y] : edges) there |= (x == a && y == b) || (x == b && y == a);
        if (!there) edges.push_back({a, b});
    }
    return edges;
}

// A hundred trees and nets of nodes with one to eight rows.
TEST(BlockLdl, matches_dense_elimination) {
    std::mt19937 random(7);
    for (int round = 0; round < 100; round++) {
        const int nodes = 1 + static_cast<int>(random() % 12);
        std::vector<int> rows;
        const int same = static_cast<int>(random() % 9);  // 0: mixed
        for (int k = 0; k < nodes; k++)
            rows.push_back(same > 0 ? same : 1 + static_cast<int>(random() % 8));
        const Problem problem(rows, random_edges(nodes, round % 3 * 3, random), random);
        BlockLdl ldl;
        ldl.analyze(problem.rows, problem.edges);
        Dense dense;
        problem.write(ldl, dense);
        std::vector<double> x(static_cast<std::size_t>(ldl.rows()));
        for (double& v : x) v = static_cast<double>(random() % 1000) / 500 - 1;
        const std::vector<double> right = x;
        ASSERT_EQ(ldl.factor(), 0);
        ldl.solve(x);
        double most = 0, size = 0;
        for (std::size_t r = 0; r < x.size(); r++) {
            double s = -right[r];
            for (std::size_t c = 0; c < x.size(); c++) s += dense[r][c] * x[c];
            most = std::max(most, std::abs(s));
            size = std::max(size, std::abs(x[r]));
        }
        EXPECT_LT(most, 1e-9 * (1 + size)) << nodes << " nodes";
        const std::vector<double> other = solve_dense(dense, right);
        for (std::size_t r = 0; r < x.size(); r++)
            EXPECT_NEAR(x[r], other[r], 1e-6 * (1 + size)) << "row " << r;
    }
}

// A node that says the same as another: one of its rows each is left out, and the rest is solved.
TEST(BlockLdl, skips_linearly_dependent_rows) {
    std::mt19937 random(3);
    Problem problem({3, 3, 2}, {{0, 1}, {0, 2}, {1, 2}}, random);
    problem.jacobian[1] = problem.jacobian[0];
    BlockLdl ldl;
    ldl.analyze(problem.rows, problem.edges);
    Dense dense;
    problem.write(ldl, dense);
    // A right-hand side on which they agree: the matrix times ones.
    std::vector<double> x(8), right(8);
    for (std::size_t r = 0; r < 8; r++)
        for (std::size_t c = 0; c < 8; c++) right[r] += dense[r][c];
    x = right;
    EXPECT_EQ(ldl.factor(), 3);
    ldl.solve(x);
    for (std::size_t r = 0; r < 8; r++) {
        double s = -right[r];
        for (std::size_t c = 0; c < 8; c++) s += dense[r][c] * x[c];
        EXPECT_LT(std::abs(s), 1e-9) << "row " << r;
    }
}

// Nothing is filled in on a chain: ten times the links, ten times the work.
TEST(BlockLdl, cost_of_a_chain_is_linear_in_its_links) {
    const auto work = [](int links) {
        std::vector<BlockLdl::Edge> edges;
        for (int k = 1; k < links; k++) edges.push_back({k - 1, k});
        BlockLdl ldl;
        ldl.analyze(std::vector<int>(static_cast<std::size_t>(links), 3), edges);
        return static_cast<double>(ldl.work()) / links;
    };
    EXPECT_NEAR(work(1000) / work(100), 1, 0.02);
}

// Minimum degree ordering causes much less fill-in than row ordering: 30 n log n blocks compared
// with n^1.5.
TEST(BlockLdl, a_grid_has_little_fill_in) {
    constexpr int side = 40;
    std::vector<BlockLdl::Edge> edges;
    for (int k = 0; k < side * side; k++) {
        if (k % side != 0) edges.push_back({k - 1, k});
        if (k >= side) edges.push_back({k - side, k});
    }
    BlockLdl ldl;
    ASSERT_TRUE(ldl.analyze(std::vector<int>(side * side, 6), edges));
    std::size_t products = 0;
    for (int k = 0; k < ldl.nodes(); k++) products += ldl.below(k).size() + ldl.updates(k).size();
    EXPECT_LT(products, 1600u * 40 * 41 / 2 / 4);
}

// Eight nodes that all meet: what that costs is known, and one multiplication less is too few.
TEST(BlockLdl, rejects_a_dense_pattern_above_the_work_limit) {
    std::vector<BlockLdl::Edge> edges;
    for (int i = 0; i < 8; i++)
        for (int k = 0; k < i; k++) edges.push_back({i, k});
    const std::vector<int> rows(8, 1);
    // 1 for each pivot, n (n + 1) / 2 for the n that lie below it.
    const int work = 8 + 28 + 21 + 15 + 10 + 6 + 3 + 1;
    BlockLdl ldl;
    EXPECT_TRUE(ldl.analyze(rows, edges, work));
    EXPECT_EQ(ldl.work(), work);
    EXPECT_FALSE(ldl.analyze(rows, edges, work - 1));
    EXPECT_EQ(physics::clique_work(8, 1), work) << "known without the edges";
    EXPECT_EQ(physics::clique_work(1, 3), 27);
    EXPECT_GT(physics::clique_work(std::size_t{1} << 40, 1), std::int64_t{1} << 60);
}

}  // namespace
}  // namespace jostle::test
