// SPDX-License-Identifier: MIT
//
// Block-sparse L D L^T of a symmetric, positive semi-definite matrix, in double. The pattern is
// analysed once and used again for each matrix of it: A. George, J. Liu, "Computer solution of
// large sparse positive definite systems", 1981; T. Davis, "Direct methods for sparse linear
// systems", 2006.
//
// A node is a few rows that belong together, an edge says that two nodes meet in the matrix. On
// trees and chains nothing is filled in, so factor and solve take time in proportion to the nodes.
// Rows that depend on others (loops of hinges have some) are found by their pivots and left out:
// their unknowns are zero, and the others solve what the rows agree on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace jostle::physics {

inline std::size_t as_index(int i) {
    return static_cast<std::size_t>(i);
}

// Whether so many joints tie so few bodies that their matrix is dense, as that of a cloth is, and
// nearly singular as soon as the cloth bends: known without a look at its pattern. A few joints on
// one body (a door on three hinges) are none.
inline bool is_net(int joints, int bodies) {
    return joints > 8 && 2 * joints > 3 * bodies;
}

// Whether so many joints tie so few bodies that many of their rows say what others say.
inline bool is_redundant(int joints, int bodies) {
    return 4 * joints > 5 * bodies;
}

// What a factor takes at least in which so many nodes of so many rows all meet each other, as the
// joints of one body do: known without a list of their edges, of which there are as many as
// squares.
inline std::int64_t clique_work(std::size_t nodes, int rows) {
    if (nodes > 1'000'000) return std::numeric_limits<std::int64_t>::max();
    const auto n = static_cast<std::int64_t>(nodes), m = std::int64_t{rows};
    return m * m * m * (n + (n - 1) * n * (n + 1) / 6);
}

class BlockLdl {
public:
    static constexpr int max_rows = 8;  // of a node
    using Edge = std::pair<int, int>;

    // By minimum degree; ties by number. Edges may occur more than once, in either direction.
    // False, and of no use, if a factor would take more multiplications than `max_work`.
    bool analyze(std::span<const int> rows_of_node, std::span<const Edge> edges,
                 std::int64_t max_work = std::numeric_limits<std::int64_t>::max());

    int nodes() const { return static_cast<int>(rows_.size()); }
    int rows() const { return begin_.empty() ? 0 : begin_.back(); }
    // Of the first unknown of a node.
    int row_of(int node) const { return begin_[static_cast<std::size_t>(position(node))]; }
    // Multiplications of one factor(): what the pattern costs.
    std::int64_t work() const { return work_; }

    // Where the block of two nodes lies among values(), row by row. The rows are those of the one
    // that is eliminated later; a block of a node with itself is read below its diagonal only.
    bool is_later(int a, int b) const { return position(a) >= position(b); }
    int block_at(int later, int sooner) const;
    std::span<double> values() { return values_; }
    void clear();

    // For other arithmetic on the same pattern, by elimination order: node, diagonal block among
    // the values, blocks below it and updates by it.
    struct Below {
        int position, at;  // the lower node by elimination order; its block among the values
    };
    struct Update {
        int at, i, j;  // block at -= L_i D L_j^T; i and j count in the column
    };
    int position(int node) const { return position_[static_cast<std::size_t>(node)]; }
    int diagonal(int at) const { return diagonal_[as_index(at)]; }
    std::span<const Below> below(int at) const { return column(below_, first_below_, at); }
    std::span<const Update> updates(int at) const { return column(updates_, first_update_, at); }
    int value_count() const { return static_cast<int>(values_.size()); }

    // Values become factors. Returns how many rows were left out as they depend on others; rows
    // of zeroes are left out, too.
    int factor();
    // x: right-hand sides in, unknowns out, by row_of().
    void solve(std::span<double> x) const;

private:
    static constexpr std::size_t max_values = max_rows * max_rows;  // of a block

    template <class T>
    static std::span<const T> column(const std::vector<T>& all, const std::vector<int>& first,
                                     int at) {
        const int begin = first[as_index(at)], end = first[as_index(at) + 1];
        return std::span(all).subspan(as_index(begin), as_index(end - begin));
    }
    int find(int row, int column) const;  // by elimination order
    std::vector<int> order_by_degree(std::span<const int> rows_of_node, std::span<const Edge> edges,
                                     std::int64_t max_work) const;
    void fill(std::span<const Edge> edges, const std::vector<int>& order);
    void count_work();
    void lay_out();
    template <int kRows>
    int factor_columns();
    template <int kRows>
    void solve_columns(double* x) const;

    std::vector<int> position_;  // by node
    // By elimination order.
    std::vector<int> rows_, begin_, diagonal_, first_below_, first_update_;
    std::vector<std::vector<int>> filled_;  // positions below each
    std::vector<Below> below_;
    std::vector<Update> updates_;
    std::vector<double> values_, inverse_, kept_, column_;
    std::vector<int> column_at_;
    std::int64_t work_ = 0;
    int same_rows_ = 0;  // of all nodes, or 0
};

}  // namespace jostle::physics
