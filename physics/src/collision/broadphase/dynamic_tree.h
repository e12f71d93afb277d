// SPDX-License-Identifier: MIT
//
// A binary tree of fat boxes (after Catto, "Dynamic Bounding Volume Hierarchies", GDC 2019).
// Insertion minimises the added surface and rotates nodes on the way up. After many moves the tree
// is rebuilt with the binned surface area heuristic (Wald, "On fast Construction of SAH-based
// Bounding Volume Hierarchies", 2007). A leaf carries a caller-defined number; the tree knows
// nothing about bodies.
//
// A node holds the boxes of both children in floats that are rounded outwards: one cache line for
// two tests. The exact boxes of the leaves decide the result.
//
// The structure of the tree depends on the order of changes. Callers that need an order sort the
// results. A loaded world, whose tree is rebuilt, then gives the same answers.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/aabb.h"
#include "physics/src/foundation/flat_array.h"

namespace jostle::physics {

class DynamicTree {
public:
    static constexpr std::int32_t null_node = -1;

    // Returns the handle of the leaf.
    std::int32_t insert(const Aabb& box, std::uint32_t item, std::uint32_t category = 1);
    void remove(std::int32_t leaf);
    void move(std::int32_t leaf, const Aabb& box);  // the handle stays valid

    // Change the box of a leaf, or add a leaf, without updating the tree. Call rebuild() before the
    // next query.
    void change(std::int32_t leaf, const Aabb& box) { at(leaf).box = box; }
    std::int32_t add(const Aabb& box, std::uint32_t item, std::uint32_t category = 1);
    // Builds a new tree from all leaves. Takes about 0.2 microseconds per leaf.
    void rebuild();

    const Aabb& box(std::int32_t leaf) const { return at(leaf).box; }
    int height() const { return root_ == none ? 0 : height_of(root_); }
    int leaf_count() const { return leaf_count_; }

    // Calls visit(box, height) for every inner node. Float rounding makes the boxes slightly larger
    // than the exact bounds.
    template <class Visit>
    void for_each_branch(Visit&& visit) const {
        Stack<Child> stack;
        if (root_ != none) stack.push(root_);
        while (!stack.empty()) {
            const Child child = stack.pop();
            if (is_leaf(child)) continue;
            visit(aabb_of(bounds_of(child)), height_of(child));
            for (const Child below : node(child).child) stack.push(below);
        }
    }

    // Calls visit(item) for every leaf whose box overlaps and whose category shares a bit with the
    // mask. Branches without such a bit are skipped.
    template <class Visit>
    void query(const Aabb& box, std::uint32_t mask, Visit&& visit) const {
        if (root_ == none) return;
        const Box outer = rounded_out(box);
        Stack<Child> stack;
        stack.push(root_);
        while (!stack.empty()) {
            const Child child = stack.pop();
            if (is_leaf(child)) {
                const Leaf& leaf = at(handle_of(child));
                if ((leaf.category & mask) != 0 && overlap(leaf.box, box)) visit(leaf.item);
                continue;
            }
            const Node& n = node(child);
            for (int k = 0; k < 2; k++)
                stack.push_if(((n.categories[k] & mask) != 0) & meet(n.box[k], outer), n.child[k]);
        }
    }

    // Calls visit(item, limit) for leaves that the segment intersects within [0, limit], nearer
    // branches first. visit() returns the new limit: the fraction of its best hit so far, or the
    // old limit.
    template <class Visit>
    void cast_ray(Vec3 origin, Vec3 motion, std::uint32_t mask, Visit&& visit) const {
        if (root_ == none) return;
        double limit = 1;
        const auto enters = [&](Child child, const Box& box, std::uint32_t categories) {
            if ((categories & mask) == 0) return 2.0;
            return ray_enters(is_leaf(child) ? at(handle_of(child)).box : aabb_of(box), origin,
                              motion, limit);
        };
        Stack<Entered> stack;
        stack.push({root_, is_leaf(root_) ? enters(root_, {}, at(handle_of(root_)).category) : 0});
        while (!stack.empty()) {
            const Entered from = stack.pop();
            if (from.fraction > limit) continue;  // a nearer hit was found since the push
            if (is_leaf(from.child)) {
                limit = visit(at(handle_of(from.child)).item, limit);
                continue;
            }
            const Node& n = node(from.child);
            Entered near{n.child[0], enters(n.child[0], n.box[0], n.categories[0])},
                far{n.child[1], enters(n.child[1], n.box[1], n.categories[1])};
            if (far.fraction < near.fraction) std::swap(near, far);
            if (far.fraction <= limit) stack.push(far);
            if (near.fraction <= limit) stack.push(near);
        }
    }

private:
    struct Box {
        float low[3], high[3];

        bool operator==(const Box&) const = default;
    };
    // Index of an inner node, or ~handle of a leaf.
    using Child = std::int32_t;
    static constexpr Child none = INT32_MIN;

    struct alignas(64) Node {
        Box box[2];
        Child child[2] = {none, none};
        std::uint32_t categories[2] = {};  // union over all leaves below
    };
    static_assert(sizeof(Node) == 64);
    // Per-node data that only updates need.
    struct Above {
        std::int32_t parent = null_node;  // next free node if on the free list
        std::int32_t height = 0;          // 0 for a leaf
    };
    struct Leaf {
        Aabb box;
        std::uint32_t item = 0;
        std::uint32_t category = 0;
        std::int32_t parent = null_node;  // next free leaf if on the free list
        bool used = false;
    };

    // A branch that a ray has yet to visit, and the fraction at which the ray enters it.
    struct Entered {
        Child child;
        double fraction;
    };

    // Depth-first order needs at most height + 1 entries. The array suffices for the tree of any
    // realistic scene; the vector holds the overflow of a degenerate tree.
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
        // Avoids a branch that the CPU cannot predict.
        void push_if(bool condition, Entry entry) {
            if (count_ >= capacity) {
                if (condition) push(entry);
                return;
            }
            small_[count_] = entry;
            count_ += condition ? 1 : 0;
        }
        Entry pop() {
            ASSERT(count_ > 0);
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

    // A leaf during construction.
    struct Sorted {
        Box box;
        std::int32_t leaf;
    };

    static bool is_leaf(Child child) { return child < 0; }
    static std::int32_t handle_of(Child leaf) { return ~leaf; }
    static Box rounded_out(const Aabb& box) {
        Box out;
        for (int k = 0; k < 3; k++) {
            const float low = static_cast<float>(box.low[k]),
                        high = static_cast<float>(box.high[k]);
            out.low[k] = low - (1.2e-7f * (low < 0 ? -low : low) + 1e-30f);
            out.high[k] = high + (1.2e-7f * (high < 0 ? -high : high) + 1e-30f);
        }
        return out;
    }
    static Aabb aabb_of(const Box& b) {
        return {{double{b.low[0]}, double{b.low[1]}, double{b.low[2]}},
                {double{b.high[0]}, double{b.high[1]}, double{b.high[2]}}};
    }
    // Branch-free, because most tests are not decided by a single axis.
    static bool meet(const Box& a, const Box& b) {
        return ((a.low[0] <= b.high[0]) & (b.low[0] <= a.high[0]) & (a.low[1] <= b.high[1]) &
                (b.low[1] <= a.high[1]) & (a.low[2] <= b.high[2]) & (b.low[2] <= a.high[2])) != 0;
    }
    static Box unite(const Box& a, const Box& b) {
        Box out;
        for (int k = 0; k < 3; k++) {
            out.low[k] = a.low[k] < b.low[k] ? a.low[k] : b.low[k];
            out.high[k] = a.high[k] > b.high[k] ? a.high[k] : b.high[k];
        }
        return out;
    }
    // Half the surface area: the cost of a box.
    static float half_area(const Box& b) {
        const float x = b.high[0] - b.low[0], y = b.high[1] - b.low[1], z = b.high[2] - b.low[2];
        return x * y + y * z + z * x;
    }

    Node& node(std::int32_t i) { return nodes_[static_cast<std::size_t>(i)]; }
    const Node& node(std::int32_t i) const { return nodes_[static_cast<std::size_t>(i)]; }
    Above& above(std::int32_t i) { return above_[static_cast<std::size_t>(i)]; }
    Leaf& at(std::int32_t leaf) { return leaves_[static_cast<std::size_t>(leaf)]; }
    const Leaf& at(std::int32_t leaf) const { return leaves_[static_cast<std::size_t>(leaf)]; }
    int height_of(Child child) const {
        return is_leaf(child) ? 0 : above_[static_cast<std::size_t>(child)].height;
    }
    Box bounds_of(Child child) const;
    std::uint32_t categories_of(Child child) const;
    void set_parent(Child child, std::int32_t parent);
    int slot_of(std::int32_t parent, Child child) const {
        return node(parent).child[0] == child ? 0 : 1;
    }

    std::int32_t allocate_node();
    void release_node(std::int32_t i);
    void link(std::int32_t leaf);
    void unlink(std::int32_t leaf);
    void measure_height(std::int32_t i);
    void refit_up(std::int32_t i);
    void rotate(std::int32_t i);
    Child build(std::span<Sorted> leaves, std::int32_t parent);

    FlatArray<Node> nodes_;
    FlatArray<Above> above_;  // one per node
    FlatArray<Leaf> leaves_;
    std::vector<Sorted> sorted_;  // scratch memory of rebuild()
    Child root_ = none;
    std::int32_t free_node_ = null_node, free_leaf_ = null_node;
    int leaf_count_ = 0;
};

}  // namespace jostle::physics
