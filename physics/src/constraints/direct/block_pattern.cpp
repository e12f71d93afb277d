// SPDX-License-Identifier: MIT
//
// The pattern of a block-sparse L D L^T: elimination order, fill-in and block positions.
#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "jostle/base/check.h"
#include "physics/src/constraints/direct/joint_net.h"

namespace jostle::physics {
namespace {

// Work for a node with `rows` rows and the nodes below it.
std::int64_t work_of(std::int64_t rows, std::span<const int> nodes_below,
                     std::span<const int> rows_of) {
    std::int64_t below = 0, squares = 0;
    for (const int node : nodes_below) {
        const std::int64_t m = rows_of[as_index(node)];
        below += m;
        squares += m * m;
    }
    // One update per pair of nodes below, and per node with itself.
    return rows * rows * rows + rows * (below * below + squares) / 2;
}

}  // namespace

// Stops early with a partial order if these nodes alone exceed `max_work`: their factor has one
// block for each remaining neighbour.
std::vector<int> BlockLdl::order_by_degree(std::span<const int> rows_of_node,
                                           std::span<const Edge> edges, std::int64_t max_work,
                                           std::span<const Sign> signs) const {
    const std::size_t n = position_.size();
    ASSERT(rows_of_node.size() == n);
    std::vector<std::vector<int>> near(n);  // each list sorted
    for (const auto& [a, b] : edges)
        if (a != b) near[as_index(a)].push_back(b), near[as_index(b)].push_back(a);
    for (std::vector<int>& list : near) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    std::set<std::pair<std::size_t, int>> queue;  // (degree, node)
    std::vector<std::uint8_t> waits(n, 0);
    for (std::size_t i = 0; i < n; i++) {
        waits[i] = !signs.empty() && signs[i] == Sign::waits ? 1 : 0;
        if (waits[i] == 0) queue.insert({near[i].size(), static_cast<int>(i)});
    }
    std::vector<int> order, others, merged;
    order.reserve(n);
    std::int64_t work = 0;
    while (!queue.empty() && work <= max_work) {
        const int node = queue.begin()->second;
        queue.erase(queue.begin());
        order.push_back(node);
        others = std::exchange(near[as_index(node)], {});
        work += work_of(rows_of_node[as_index(node)], others, rows_of_node);
        ASSERT(work >= 0);
        // The elimination couples all neighbours of the node.
        for (const int a : others) {
            std::vector<int>& list = near[as_index(a)];
            const std::size_t old_size = list.size();
            merged.clear();
            std::set_union(list.begin(), list.end(), others.begin(), others.end(),
                           std::back_inserter(merged));
            std::erase_if(merged, [&](int other) { return other == node || other == a; });
            list.swap(merged);
            const bool released =
                waits[as_index(a)] != 0 && signs[as_index(node)] == Sign::negative;
            if (released) waits[as_index(a)] = 0;
            if (waits[as_index(a)] != 0 || (list.size() == old_size && !released)) continue;
            if (!released) queue.erase({old_size, a});
            queue.insert({list.size(), a});
        }
    }
    return order;
}

// The nodes below each node include the nodes below its children in the elimination tree.
void BlockLdl::fill(std::span<const Edge> edges, const std::vector<int>& order) {
    const std::size_t n = order.size();
    for (std::size_t p = 0; p < n; p++) position_[as_index(order[p])] = static_cast<int>(p);
    std::vector<std::vector<int>> coupled(n), children(n);
    for (const auto& [a, b] : edges) {
        const int p = position(a), q = position(b);
        if (p != q) coupled[as_index(std::min(p, q))].push_back(std::max(p, q));
        ASSERT(p >= 0 && q >= 0);
    }
    filled_.assign(n, {});
    std::vector<int> mark(n, -1);
    for (int k = 0; k < static_cast<int>(n); k++) {
        std::vector<int>& list = filled_[as_index(k)];
        const auto take = [&](int row) {
            if (row <= k || mark[as_index(row)] == k) return;
            ASSERT(row < static_cast<int>(n));
            mark[as_index(row)] = k;
            list.push_back(row);
        };
        for (const int row : coupled[as_index(k)]) take(row);
        for (const int child : children[as_index(k)])
            for (const int row : filled_[as_index(child)]) take(row);
        std::sort(list.begin(), list.end());
        if (!list.empty()) children[as_index(list.front())].push_back(k);
    }
}

void BlockLdl::count_work() {
    work_ = 0;
    for (std::size_t k = 0; k < rows_.size(); k++) work_ += work_of(rows_[k], filled_[k], rows_);
}

void BlockLdl::lay_out() {
    const std::size_t n = rows_.size();
    diagonal_.resize(n);
    ASSERT(filled_.size() == n && begin_.size() == n + 1);
    first_below_.assign(n + 1, 0);
    first_update_.assign(n + 1, 0);
    below_.clear();
    updates_.clear();
    int size = 0;
    for (std::size_t k = 0; k < n; k++) {
        diagonal_[k] = size;
        size += rows_[k] * rows_[k];
        first_below_[k] = static_cast<int>(below_.size());
        for (const int row : filled_[k]) {
            below_.push_back({row, size});
            size += rows_[as_index(row)] * rows_[k];
        }
    }
    first_below_[n] = static_cast<int>(below_.size());
    for (std::size_t k = 0; k < n; k++) {
        first_update_[k] = static_cast<int>(updates_.size());
        const int first = first_below_[k], last = first_below_[k + 1];
        for (int j = first; j < last; j++) {
            const int column = below_[as_index(j)].position;
            updates_.push_back({diagonal_[as_index(column)], j - first, j - first});
            // The rows below j also exist in its own column, in the same order.
            std::size_t at = as_index(first_below_[as_index(column)]);
            for (int i = j + 1; i < last; i++) {
                while (below_[at].position != below_[as_index(i)].position) at++;
                updates_.push_back({below_[at].at, i - first, j - first});
            }
        }
    }
    first_update_[n] = static_cast<int>(updates_.size());
    values_.assign(as_index(size), 0);
    const int most = n == 0 ? 0 : *std::max_element(rows_.begin(), rows_.end());
    block_values_ = as_index(most * most);
    inverse_.assign(n * block_values_, 0);
    original_diagonal_.assign(as_index(rows()), 0);
}

bool BlockLdl::analyze(std::span<const int> rows_of_node, std::span<const Edge> edges,
                       std::int64_t max_work, std::span<const Sign> signs) {
    const std::size_t n = rows_of_node.size();
    ASSERT(signs.empty() || signs.size() == n);
    position_.assign(n, 0);
    const std::vector<int> order = order_by_degree(rows_of_node, edges, max_work, signs);
    if (order.size() < n) return false;
    fill(edges, order);
    rows_.resize(n);
    begin_.assign(n + 1, 0);
    same_rows_ = n == 0 ? 0 : rows_of_node[0];
    for (std::size_t p = 0; p < n; p++) {
        rows_[p] = rows_of_node[as_index(order[p])];
        ASSERT(rows_[p] >= 1 && rows_[p] <= max_rows);
        begin_[p + 1] = begin_[p] + rows_[p];
        if (rows_[p] != same_rows_) same_rows_ = 0;
    }
    negative_.clear();
    if (!signs.empty())
        for (const int node : order)
            negative_.push_back(signs[as_index(node)] == Sign::negative ? 1 : 0);
    count_work();
    if (work_ > max_work) return false;
    lay_out();
    return true;
}

int BlockLdl::find(int row, int column) const {
    if (row == column) return diagonal_[as_index(column)];
    const auto first = below_.begin() + first_below_[as_index(column)];
    const auto last = below_.begin() + first_below_[as_index(column) + 1];
    const auto found = std::lower_bound(
        first, last, row, [](const Below& b, int target) { return b.position < target; });
    ASSERT(found != last && found->position == row);
    return found->at;
}

int BlockLdl::block_at(int later, int sooner) const {
    return find(position(later), position(sooner));
}

}  // namespace jostle::physics
