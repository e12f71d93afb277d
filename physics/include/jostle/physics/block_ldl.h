// SPDX-License-Identifier: MIT
//
// Block-sparse L D L^T of a symmetric, positive semi-definite or quasi-definite matrix in double,
// for groups of joints and for modules that solve systems of their own. The pattern is analysed
// once and reused for every matrix with that pattern (A. George, J. Liu, "Computer solution of
// large sparse positive definite systems", 1981; T. Davis, "Direct methods for sparse linear
// systems", 2006).
//
// A node is a group of rows. An edge means that the matrix couples two nodes. Trees and chains have
// no fill-in, so factor and solve take time proportional to the number of nodes. Dependent rows, as
// in some loops of hinges, are detected by their pivots and skipped: their unknowns are zero, and
// the other rows solve the consistent part.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace jostle::physics {

/// Factorises and solves. Not thread-safe, except that several threads may call solve() at once.
class BlockLdl {
public:
    static constexpr int max_rows = 8;  ///< per node
    using Edge = std::pair<int, int>;
    /// The sign of a node's diagonal block. Negative nodes make the matrix quasi-definite (R.
    /// Vanderbei, 1995). A node that is positive only after the elimination of a negative neighbour
    /// waits for it.
    enum class Sign : std::uint8_t { positive, negative, waits };

    /// Orders the elimination by minimum degree, then by number. Edges may occur more than once, in
    /// either direction. Returns false, and the object is then unusable, if a factorisation would
    /// take more than `max_work` multiplications. Precondition: 1 to max_rows rows per node.
    /// `signs`: indexed by node; empty if all nodes are positive.
    bool analyze(std::span<const int> rows_of_node, std::span<const Edge> edges,
                 std::int64_t max_work = std::numeric_limits<std::int64_t>::max(),
                 std::span<const Sign> signs = {});

    int nodes() const { return static_cast<int>(rows_.size()); }
    int rows() const { return begin_.empty() ? 0 : begin_.back(); }
    /// Index of the first unknown of a node.
    int row_of(int node) const { return begin_[static_cast<std::size_t>(position(node))]; }
    /// Multiplications of one factor(): the cost of the pattern.
    std::int64_t work() const { return work_; }

    /// Index of the block of two nodes in values(), row-major. The rows belong to the node that is
    /// eliminated later. Only the lower triangle of a diagonal block is read.
    bool is_later(int a, int b) const { return position(a) >= position(b); }
    int block_at(int later, int sooner) const;
    std::span<double> values() { return values_; }
    void clear();  ///< sets all values to 0

    /// The pattern in elimination order, for other arithmetic on it: nodes, diagonal blocks in the
    /// values, the blocks below them and their updates.
    struct Below {
        int position, at;  ///< the lower node by elimination order; its block in the values
    };
    struct Update {
        int at, i, j;  ///< block at -= L_i D L_j^T; i and j index the column
    };
    int position(int node) const { return position_[static_cast<std::size_t>(node)]; }
    int diagonal(int at) const { return diagonal_[static_cast<std::size_t>(at)]; }
    std::span<const Below> below(int at) const { return column(below_, first_below_, at); }
    std::span<const Update> updates(int at) const { return column(updates_, first_update_, at); }
    int value_count() const { return static_cast<int>(values_.size()); }

    /// A pivot that elimination reduces to this fraction of its diagonal, or less, depends on
    /// earlier rows.
    static constexpr double dependent_pivot = 1e-10;
    /// Replaces the values with factors. Returns the number of rows skipped because they depend on
    /// others, according to `dependent`. Zero rows are skipped, too.
    int factor(double dependent = dependent_pivot);
    /// x: right-hand sides in, unknowns out, indexed by row_of().
    void solve(std::span<double> x) const;

private:
    template <class T>
    static std::span<const T> column(const std::vector<T>& all, const std::vector<int>& first,
                                     int at) {
        const int begin = first[static_cast<std::size_t>(at)],
                  end = first[static_cast<std::size_t>(at) + 1];
        return std::span(all).subspan(static_cast<std::size_t>(begin),
                                      static_cast<std::size_t>(end - begin));
    }
    int find(int row, int column) const;  // in elimination order
    std::vector<int> order_by_degree(std::span<const int> rows_of_node, std::span<const Edge> edges,
                                     std::int64_t max_work, std::span<const Sign> signs) const;
    void fill(std::span<const Edge> edges, const std::vector<int>& order);
    void count_work();
    void lay_out();
    template <int kPivots, bool kSame>
    int factor_column(int k, double dependent);
    template <int kRows>
    int factor_columns(double dependent);
    template <int kPivots, bool kSame>
    void eliminate_column(int k, double* x) const;
    template <int kPivots, bool kSame>
    void substitute_column(int k, double* x) const;
    template <int kRows>
    void solve_columns(double* x) const;

    std::vector<int> position_;  // indexed by node
    // In elimination order.
    std::vector<int> rows_, begin_, diagonal_, first_below_, first_update_;
    std::vector<std::uint8_t> negative_;    // empty if no node is
    std::vector<std::vector<int>> filled_;  // positions below each node
    std::vector<Below> below_;
    std::vector<Update> updates_;
    std::vector<double> values_, inverse_, original_diagonal_, column_;
    std::vector<int> column_at_;
    std::int64_t work_ = 0;
    std::size_t block_values_ = 0;  // of the largest block
    int same_rows_ = 0;             // rows of every node, or 0 if they differ
};

}  // namespace jostle::physics
