// SPDX-License-Identifier: MIT
#include "collision/broadphase/dynamic_tree.h"

#include "foundation/check.h"

namespace jostle::physics {

std::int32_t DynamicTree::allocate() {
    if (free_ == null_node) {
        nodes_.emplace_back();
        return static_cast<std::int32_t>(nodes_.size() - 1);
    }
    const std::int32_t i = free_;
    free_ = node(i).parent;
    node(i) = Node{};
    return i;
}

void DynamicTree::release(std::int32_t i) {
    node(i).parent = free_;
    free_ = i;
}

std::int32_t DynamicTree::insert(const Aabb& box, std::uint32_t item, std::uint32_t category) {
    const std::int32_t leaf = allocate();
    node(leaf).box = box;
    node(leaf).item = item;
    node(leaf).categories = category;
    link(leaf);
    leaf_count_++;
    return leaf;
}

void DynamicTree::remove(std::int32_t leaf) {
    unlink(leaf);
    release(leaf);
    leaf_count_--;
}

void DynamicTree::move(std::int32_t leaf, const Aabb& box) {
    unlink(leaf);
    node(leaf).box = box;
    link(leaf);
}

void DynamicTree::clear() {
    *this = DynamicTree{};
}

// Walks down while a child can take the leaf for less added surface than making a sibling here.
std::int32_t DynamicTree::best_sibling(const Aabb& box) const {
    std::int32_t i = root_;
    while (node(i).left != null_node) {
        const Node& n = node(i);
        const double area = half_area(n.box), together = half_area(unite(n.box, box));
        const double here = 2 * together, inherited = 2 * (together - area);
        const auto cost = [&](std::int32_t child) {
            const Node& c = node(child);
            const double grown = half_area(unite(c.box, box));
            return inherited + (c.left == null_node ? grown : grown - half_area(c.box));
        };
        const double left = cost(n.left), right = cost(n.right);
        if (here < left && here < right) break;
        // Equal boxes: the lower side, or a thousand bodies in one place would make a chain.
        if (left == right)
            i = node(n.left).height <= node(n.right).height ? n.left : n.right;
        else
            i = left < right ? n.left : n.right;
    }
    return i;
}

void DynamicTree::replace_child(std::int32_t parent, std::int32_t old_child,
                                std::int32_t new_child) {
    if (parent == null_node)
        root_ = new_child;
    else if (node(parent).left == old_child)
        node(parent).left = new_child;
    else
        node(parent).right = new_child;
}

void DynamicTree::link(std::int32_t leaf) {
    if (root_ == null_node) {
        root_ = leaf;
        node(leaf).parent = null_node;
        return;
    }
    const std::int32_t sibling = best_sibling(node(leaf).box);
    const std::int32_t parent = allocate();
    const std::int32_t above = node(sibling).parent;
    node(parent).parent = above;
    node(parent).left = sibling;
    node(parent).right = leaf;
    replace_child(above, sibling, parent);
    node(sibling).parent = parent;
    node(leaf).parent = parent;
    refit_up(parent);
}

void DynamicTree::unlink(std::int32_t leaf) {
    if (leaf == root_) {
        root_ = null_node;
        return;
    }
    const std::int32_t parent = node(leaf).parent, above = node(parent).parent;
    const std::int32_t sibling = node(parent).left == leaf ? node(parent).right : node(parent).left;
    replace_child(above, parent, sibling);
    node(sibling).parent = above;
    release(parent);
    refit_up(above);
}

void DynamicTree::update(std::int32_t i) {
    Node& n = node(i);
    const Node &l = node(n.left), &r = node(n.right);
    n.box = unite(l.box, r.box);
    n.categories = l.categories | r.categories;
    n.height = 1 + (l.height > r.height ? l.height : r.height);
}

void DynamicTree::refit_up(std::int32_t i) {
    while (i != null_node) {
        const Node before = node(i);
        update(i);
        rotate(i);
        const Node& now = node(i);
        if (now.box == before.box && now.height == before.height &&
            now.categories == before.categories)
            return;  // what is above sees no change
        i = now.parent;
    }
}

// Swaps a child of i with a grandchild under the other child when that shrinks the box in between.
void DynamicTree::rotate(std::int32_t i) {
    struct Swap {
        std::int32_t child = null_node, other = null_node, grandchild = null_node;
        double gain = 1e-9;
    } best;
    const auto consider = [&](std::int32_t child, std::int32_t other) {
        if (node(other).left == null_node) return;
        for (const bool left : {true, false}) {
            const std::int32_t grandchild = left ? node(other).left : node(other).right;
            const std::int32_t stays = left ? node(other).right : node(other).left;
            const double gain =
                half_area(node(other).box) - half_area(unite(node(child).box, node(stays).box));
            if (gain > best.gain) best = {child, other, grandchild, gain};
        }
    };
    consider(node(i).left, node(i).right);
    consider(node(i).right, node(i).left);
    if (best.child == null_node) return;
    replace_child(i, best.child, best.grandchild);
    replace_child(best.other, best.grandchild, best.child);
    node(best.grandchild).parent = i;
    node(best.child).parent = best.other;
    update(best.other);
    update(i);
}

}  // namespace jostle::physics
