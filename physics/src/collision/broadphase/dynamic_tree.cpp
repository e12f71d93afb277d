// SPDX-License-Identifier: MIT
#include "physics/src/collision/broadphase/dynamic_tree.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::physics {

DynamicTree::Box DynamicTree::bounds_of(Child child) const {
    if (is_leaf(child)) return rounded_out(at(handle_of(child)).box);
    return unite(node(child).box[0], node(child).box[1]);
}

std::uint32_t DynamicTree::categories_of(Child child) const {
    if (is_leaf(child)) return at(handle_of(child)).category;
    return node(child).categories[0] | node(child).categories[1];
}

void DynamicTree::set_parent(Child child, std::int32_t parent) {
    ASSERT(child != none && (parent == null_node || !is_leaf(parent)));
    (is_leaf(child) ? at(handle_of(child)).parent : above(child).parent) = parent;
}

std::int32_t DynamicTree::allocate_node() {
    if (free_node_ == null_node) {
        nodes_.emplace_back();
        above_.emplace_back();
        return static_cast<std::int32_t>(nodes_.size() - 1);
    }
    const std::int32_t i = free_node_;
    ASSERT(static_cast<std::size_t>(i) < nodes_.size() && above_.size() == nodes_.size());
    free_node_ = above(i).parent;
    above(i) = {};
    return i;
}

void DynamicTree::release_node(std::int32_t i) {
    ASSERT(i >= 0 && i != free_node_);
    above(i).parent = free_node_;
    free_node_ = i;
}

std::int32_t DynamicTree::add(const Aabb& box, std::uint32_t item, std::uint32_t category) {
    std::int32_t leaf = free_leaf_;
    if (leaf == null_node) {
        leaves_.emplace_back();
        leaf = static_cast<std::int32_t>(leaves_.size() - 1);
    } else {
        free_leaf_ = at(leaf).parent;
        ASSERT(!at(leaf).used);
    }
    at(leaf) = {box, item, category, null_node, true};
    leaf_count_++;
    ASSERT(static_cast<std::size_t>(leaf_count_) <= leaves_.size());
    return leaf;
}

std::int32_t DynamicTree::insert(const Aabb& box, std::uint32_t item, std::uint32_t category) {
    const std::int32_t leaf = add(box, item, category);
    link(leaf);
    return leaf;
}

void DynamicTree::remove(std::int32_t leaf) {
    ASSERT(at(leaf).used && leaf_count_ > 0);
    unlink(leaf);
    at(leaf).used = false;
    at(leaf).parent = free_leaf_;
    free_leaf_ = leaf;
    leaf_count_--;
}

void DynamicTree::move(std::int32_t leaf, const Aabb& box) {
    ASSERT(at(leaf).used);
    unlink(leaf);
    at(leaf).box = box;
    link(leaf);
}

// Descends while inserting the leaf into a child adds less surface than creating a sibling at this
// node.
void DynamicTree::link(std::int32_t leaf) {
    const Child child = ~leaf;
    ASSERT(is_leaf(child) && at(leaf).used);
    if (root_ == none) {
        root_ = child;
        set_parent(child, null_node);
        return;
    }
    const Box box = bounds_of(child);
    Child sibling = root_;
    Box sibling_box = bounds_of(root_);
    std::int32_t parent = null_node;
    while (!is_leaf(sibling)) {
        const Node& n = node(sibling);
        const float together = half_area(unite(sibling_box, box));
        const float here = 2 * together, inherited = 2 * (together - half_area(sibling_box));
        // Exact cost for a leaf and a lower bound for an inner node: the growth of the box, plus
        // the new node at the bottom, which is at least as large as the inserted box (as in Box2D
        // 3). Without the second term, coincident boxes would never be paired and would form a
        // chain.
        const auto cost = [&](int k) {
            const float grown = half_area(unite(n.box[k], box));
            if (is_leaf(n.child[k])) return inherited + grown;
            return inherited + grown + std::min(half_area(box) - half_area(n.box[k]), 0.0f);
        };
        const float first = cost(0), second = cost(1);
        if (here < first && here < second) break;
        // For equal boxes choose the lower side; otherwise a thousand coincident bodies would form
        // a chain.
        int side = first < second ? 0 : 1;
        if (first == second) side = height_of(n.child[0]) <= height_of(n.child[1]) ? 0 : 1;
        parent = sibling;
        sibling_box = n.box[side];
        sibling = n.child[side];
    }
    const std::int32_t made = allocate_node();
    Node& n = node(made);
    n.child[0] = sibling;
    n.child[1] = child;
    n.box[0] = sibling_box;
    n.box[1] = box;
    n.categories[0] = categories_of(sibling);
    n.categories[1] = categories_of(child);
    if (parent == null_node)
        root_ = made;
    else
        node(parent).child[slot_of(parent, sibling)] = made;
    set_parent(made, parent);
    set_parent(sibling, made);
    set_parent(child, made);
    refit_up(made);
}

void DynamicTree::unlink(std::int32_t leaf) {
    const Child child = ~leaf;
    if (child == root_) {
        root_ = none;
        return;
    }
    const std::int32_t parent = at(leaf).parent, grand = above(parent).parent;
    ASSERT(parent != null_node && grand != parent);
    const int other = 1 - slot_of(parent, child);
    const Child sibling = node(parent).child[other];
    set_parent(sibling, grand);
    if (grand == null_node) {
        root_ = sibling;
    } else {
        const int slot = slot_of(grand, parent);
        node(grand).child[slot] = sibling;
        node(grand).box[slot] = node(parent).box[other];
        node(grand).categories[slot] = node(parent).categories[other];
    }
    release_node(parent);
    if (grand != null_node) refit_up(grand);
}

void DynamicTree::measure_height(std::int32_t i) {
    const Node& n = node(i);
    above(i).height = 1 + std::max(height_of(n.child[0]), height_of(n.child[1]));
    ASSERT(above(i).height < leaf_count_);
}

// Refits the ancestors of a node after one of its children changed.
void DynamicTree::refit_up(std::int32_t i) {
    for (;;) {
        const int old_height = above(i).height;
        measure_height(i);
        rotate(i);
        const std::int32_t parent = above(i).parent;
        if (parent == null_node) return;
        Node& p = node(parent);
        const int slot = slot_of(parent, i);
        const Box box = bounds_of(i);
        const std::uint32_t categories = categories_of(i);
        if (above(i).height == old_height && p.box[slot] == box && p.categories[slot] == categories)
            return;  // the ancestors do not change
        p.box[slot] = box;
        p.categories[slot] = categories;
        i = parent;
    }
}

// Swaps a child of i with a grandchild under the other child if that shrinks the box of that child.
void DynamicTree::rotate(std::int32_t i) {
    struct Swap {
        int side = -1, grandchild = 0;
        float gain = 1e-9f;
    } best;
    Node& n = node(i);
    for (const int side : {0, 1}) {
        const Child other = n.child[1 - side];
        if (is_leaf(other)) continue;
        const Node& o = node(other);
        for (const int k : {0, 1}) {
            const float gain =
                half_area(n.box[1 - side]) - half_area(unite(n.box[side], o.box[1 - k]));
            if (gain > best.gain) best = {side, k, gain};
        }
    }
    if (best.side < 0) return;
    ASSERT(best.gain > 0 && !is_leaf(n.child[1 - best.side]));
    const std::int32_t other = n.child[1 - best.side];
    Node& o = node(other);
    std::swap(n.child[best.side], o.child[best.grandchild]);
    std::swap(n.box[best.side], o.box[best.grandchild]);
    std::swap(n.categories[best.side], o.categories[best.grandchild]);
    set_parent(n.child[best.side], i);
    set_parent(o.child[best.grandchild], other);
    n.box[1 - best.side] = bounds_of(other);
    n.categories[1 - best.side] = categories_of(other);
    measure_height(other);
    measure_height(i);
}

// ---- bulk construction ----

void DynamicTree::rebuild() {
    nodes_.clear();
    above_.clear();
    free_node_ = null_node;
    sorted_.clear();
    for (std::size_t k = 0; k < leaves_.size(); k++)
        if (leaves_[k].used)
            sorted_.push_back({rounded_out(leaves_[k].box), static_cast<std::int32_t>(k)});
    if (sorted_.empty()) {
        root_ = none;
        return;
    }
    nodes_.reserve(sorted_.size() - 1);
    ASSERT(sorted_.size() == static_cast<std::size_t>(leaf_count_));
    above_.reserve(sorted_.size() - 1);
    root_ = build(sorted_, null_node);
    sorted_.clear();  // so that copies of the tree do not copy it
    ASSERT(nodes_.size() + 1 == static_cast<std::size_t>(leaf_count_));
}

// Allocates nodes in the order in which a query descends.
DynamicTree::Child DynamicTree::build(std::span<Sorted> leaves, std::int32_t parent) {
    if (leaves.size() == 1) {
        at(leaves[0].leaf).parent = parent;
        return ~leaves[0].leaf;
    }
    // Split along the axis with the largest extent of the box centres (stored doubled).
    const auto middle = [](const Box& b, int k) { return b.low[k] + b.high[k]; };
    float low[3], high[3];
    for (int k = 0; k < 3; k++) low[k] = high[k] = middle(leaves[0].box, k);
    for (const Sorted& leaf : leaves)
        for (int k = 0; k < 3; k++) {
            low[k] = std::min(low[k], middle(leaf.box, k));
            high[k] = std::max(high[k], middle(leaf.box, k));
        }
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (high[k] - low[k] > high[axis] - low[axis]) axis = k;

    std::size_t cut = leaves.size() / 2;
    constexpr int bins = 8;
    const float width = high[axis] - low[axis];
    const float scale = static_cast<float>(bins) / width;
    if (leaves.size() > 2 && width > 0 && scale < 1e30f) {
        const auto bin_of = [&](const Sorted& leaf) {
            // For boxes beyond the float range this is infinite or NaN.
            const float at = (middle(leaf.box, axis) - low[axis]) * scale;
            return at < static_cast<float>(bins) ? static_cast<int>(at) : bins - 1;
        };
        std::size_t count[bins] = {};
        Box box[bins];
        for (const Sorted& leaf : leaves) {
            const int b = bin_of(leaf);
            box[b] = count[b] == 0 ? leaf.box : unite(box[b], leaf.box);
            count[b]++;
        }
        // Cost of the upper bins, accumulated from the top.
        float upper[bins] = {};
        Box sum;
        std::size_t many = 0;
        for (int b = bins - 1; b > 0; b--) {
            if (count[b] != 0) sum = many == 0 ? box[b] : unite(sum, box[b]);
            many += count[b];
            upper[b] = many == 0 ? 0 : half_area(sum) * static_cast<float>(many);
        }
        // The lowest and the highest bin are never empty, so every split has leaves on both sides.
        int best = 1;
        float least = 0;
        many = 0;
        for (int b = 1; b < bins; b++) {
            if (count[b - 1] != 0) sum = many == 0 ? box[b - 1] : unite(sum, box[b - 1]);
            many += count[b - 1];
            const float cost = half_area(sum) * static_cast<float>(many) + upper[b];
            if (b == 1 || cost < least) {
                best = b;
                least = cost;
            }
        }
        const auto end = std::partition(leaves.begin(), leaves.end(),
                                        [&](const Sorted& leaf) { return bin_of(leaf) < best; });
        cut = static_cast<std::size_t>(end - leaves.begin());
    }
    // If all centres coincide, any half is as good.
    if (cut == 0 || cut == leaves.size()) cut = leaves.size() / 2;
    ASSERT(cut > 0 && cut < leaves.size());

    const std::int32_t made = allocate_node();
    above(made).parent = parent;
    const Child first = build(leaves.first(cut), made), second = build(leaves.subspan(cut), made);
    Node& n = node(made);
    n.child[0] = first;
    n.child[1] = second;
    for (int k = 0; k < 2; k++) {
        n.box[k] = bounds_of(n.child[k]);
        n.categories[k] = categories_of(n.child[k]);
    }
    measure_height(made);
    return made;
}

}  // namespace jostle::physics
