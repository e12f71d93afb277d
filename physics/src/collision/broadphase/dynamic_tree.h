// SPDX-License-Identifier: MIT
//
// A binary tree of fat boxes (after Catto, "Dynamic Bounding Volume Hierarchies", GDC 2019): insert
// by least added surface, rotate on the way up. A leaf carries a caller's number; the tree knows
// nothing of bodies.
//
// The shape of the tree depends on the order of inserts. Callers that need an order sort what they
// get: then a loaded world, whose tree is built anew, answers the same.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "foundation/flat_array.h"
#include "jostle/physics/aabb.h"

namespace jostle::physics {

class DynamicTree {
public:
    static constexpr std::int32_t null_node = -1;

    // Returns the leaf's handle.
    std::int32_t insert(const Aabb& box, std::uint32_t item, std::uint32_t category = 1);
    void remove(std::int32_t leaf);
    void move(std::int32_t leaf, const Aabb& box);  // handle stays
    void clear();

    const Aabb& box(std::int32_t leaf) const { return nodes_[static_cast<std::size_t>(leaf)].box; }
    int height() const { return root_ == null_node ? 0 : node(root_).height; }
    int leaf_count() const { return leaf_count_; }

    // Calls visit(box, height) for every inner node.
    template <class Visit>
    void for_each_branch(Visit&& visit) const {
        if (root_ == null_node) return;
        Stack<std::int32_t> stack;
        stack.push(root_);
        while (!stack.empty()) {
            const Node& n = node(stack.pop());
            if (n.left == null_node) continue;
            visit(n.box, n.height);
            stack.push(n.left);
            stack.push(n.right);
        }
    }

    // Calls visit(item) for every leaf whose box overlaps and whose category has a bit in the mask;
    // whole branches without such a bit are left out.
    template <class Visit>
    void query(const Aabb& box, std::uint32_t mask, Visit&& visit) const {
        if (root_ == null_node) return;
        Stack<std::int32_t> stack;
        stack.push(root_);
        while (!stack.empty()) {
            const Node& n = node(stack.pop());
            if ((n.categories & mask) == 0 || !overlap(n.box, box)) continue;
            if (n.left == null_node) {
                visit(n.item);
            } else {
                stack.push(n.left);
                stack.push(n.right);
            }
        }
    }

    // Calls visit(item, limit) for leaves that the segment meets within [0, limit], nearer branches
    // first; visit returns the new limit (the fraction of its best hit so far, or the old limit).
    template <class Visit>
    void cast_ray(Vec3 origin, Vec3 motion, std::uint32_t mask, Visit&& visit) const {
        if (root_ == null_node) return;
        double limit = 1;
        const auto enters = [&](const Node& n) {
            return (n.categories & mask) == 0 ? 2 : ray_enters(n.box, origin, motion, limit);
        };
        Stack<Entered> stack;
        stack.push({root_, enters(node(root_))});
        while (!stack.empty()) {
            const Entered at = stack.pop();
            if (at.fraction > limit) continue;  // a hit came nearer since it was put there
            const Node& n = node(at.node);
            if (n.left == null_node) {
                limit = visit(n.item, limit);
                continue;
            }
            Entered near{n.left, enters(node(n.left))}, far{n.right, enters(node(n.right))};
            if (far.fraction < near.fraction) std::swap(near, far);
            if (far.fraction <= limit) stack.push(far);
            if (near.fraction <= limit) stack.push(near);
        }
    }

private:
    struct Node {
        Aabb box;
        std::int32_t parent = null_node;  // next free node when on the free list
        std::int32_t left = null_node, right = null_node;
        std::int32_t height = 0;  // leaf 0
        std::uint32_t item = 0;
        std::uint32_t categories = 0;  // of all leaves below
    };

    // A branch that a ray is still to look into, and where along the ray it begins.
    struct Entered {
        std::int32_t node;
        double fraction;
    };

    // Depth-first order needs at most height + 1 entries; the array is enough for any tree of a
    // real scene, the vector takes what a degenerate one would add.
    template <class Entry>
    class Stack {
    public:
        void push(Entry entry) {
            if (count_ < capacity)
                small_[count_] = entry;
            else
                more_.push_back(entry);
            count_++;
        }
        Entry pop() {
            count_--;
            if (count_ < capacity) return small_[count_];
            const Entry entry = more_.back();
            more_.pop_back();
            return entry;
        }
        bool empty() const { return count_ == 0; }

    private:
        static constexpr int capacity = 128;
        Entry small_[capacity];
        int count_ = 0;
        std::vector<Entry> more_;
    };

    Node& node(std::int32_t i) { return nodes_[static_cast<std::size_t>(i)]; }
    const Node& node(std::int32_t i) const { return nodes_[static_cast<std::size_t>(i)]; }
    std::int32_t allocate();
    void release(std::int32_t i);
    std::int32_t best_sibling(const Aabb& box) const;
    void link(std::int32_t leaf);
    void unlink(std::int32_t leaf);
    void refit_up(std::int32_t i);
    void update(std::int32_t i);
    void rotate(std::int32_t i);
    void replace_child(std::int32_t parent, std::int32_t old_child, std::int32_t new_child);

    FlatArray<Node> nodes_;
    std::int32_t root_ = null_node;
    std::int32_t free_ = null_node;
    int leaf_count_ = 0;
};

}  // namespace jostle::physics
