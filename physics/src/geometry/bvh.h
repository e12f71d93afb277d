// SPDX-License-Identifier: MIT
//
// A static bounding volume hierarchy over items with boxes: the triangles of a mesh or the children
// of a compound. Built as a binary tree by binned splitting with the surface area heuristic (Wald,
// "On fast construction of SAH-based bounding volume hierarchies", 2007), then collapsed to a
// four-way tree (Wald, Benthin, Boulos, "Getting rid of packets", 2008), whose nodes test four
// child boxes at a time. Items are visited in the order of the binary tree: left before right,
// items of a leaf in ascending order.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/geometry/box_lanes.h"

namespace jostle::physics {

class Bvh {
public:
    Bvh() = default;
    explicit Bvh(std::span<const Aabb> boxes);

    bool empty() const { return nodes_.empty(); }
    int height() const { return height_; }  // of the four-way tree

    // Calls visit(item) for every item whose box overlaps, and for some whose box does not because
    // of rounding to float. The caller must test the item itself.
    template <class Visit>
    void query(const Aabb& box, Visit&& visit) const {
        if (nodes_.empty()) return;
        const BoxLanes query_box = broadcast(box);
        std::uint32_t stack[stack_size];
        int top = 0;
        stack[top++] = 0;
        while (top > 0) {
            const Node& n = nodes_[stack[--top]];
            unsigned lanes = overlapping(query_box, n.boxes);
            if (n.leaf) {
                for (; lanes != 0; lanes &= lanes - 1) visit(n.child[std::countr_zero(lanes)]);
                continue;
            }
            // Push in reverse order, so that the first child is on top.
            while (lanes != 0) {
                const int last = std::bit_width(lanes) - 1;
                ASSERT(last < 4 && top < stack_size);
                stack[top++] = n.child[last];
                lanes &= ~(1u << last);
            }
        }
    }

    // Calls visit(item, limit) for items whose box the segment enters within [0, limit],
    // approximately nearest first, and for some that it misses because of rounding to float.
    // visit() returns the new limit.
    template <class Visit>
    void cast_ray(Vec3 origin, Vec3 motion, double limit, Visit&& visit) const {
        const RayOverlap meets(origin, motion);
        nearest_first(
            [&](const BoxLanes& boxes, bool, Float4& key) { return meets(boxes, limit, key); },
            [&](std::uint32_t item) { limit = visit(item, limit); });
    }

    // Traverses the tree. test(boxes, leaf, key) returns a mask of the four boxes to visit;
    // visit(item) is called for items in leaves. Children of a node are visited by ascending key,
    // and from left to right for equal keys.
    template <class Test, class Visit>
    void nearest_first(Test&& test, Visit&& visit) const {
        if (nodes_.empty()) return;
        std::uint32_t stack[stack_size];
        int top = 0;
        stack[top++] = 0;
        while (top > 0) {
            const Node& n = nodes_[stack[--top]];
            Float4 key;
            unsigned lanes = test(n.boxes, n.leaf, key);
            int order[4], count = 0;
            ASSERT(lanes < 16 && top + 4 <= stack_size);
            for (; lanes != 0; lanes &= lanes - 1) {
                const int lane = std::countr_zero(lanes);
                int at = count++;
                for (; at > 0 && key[lane] < key[order[at - 1]]; at--) order[at] = order[at - 1];
                order[at] = lane;
            }
            if (n.leaf)
                for (int k = 0; k < count; k++) visit(n.child[order[k]]);
            else
                while (count > 0) stack[top++] = n.child[order[--count]];
        }
    }

private:
    static constexpr int max_height = 60;                  // of the binary tree
    static constexpr int stack_size = 3 * max_height + 4;  // each popped node pushes up to four
    struct alignas(64) Node {
        BoxLanes boxes;
        std::uint32_t child[4] = {};  // items of a leaf, otherwise nodes
        bool leaf = false;
    };
    struct BinaryNode;
    void split(std::vector<BinaryNode>& binary, std::uint32_t node, std::span<const Aabb> boxes,
               int depth);
    void collapse(const std::vector<BinaryNode>& binary, std::uint32_t node,
                  std::span<const Aabb> boxes, int depth);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;  // used during construction only
    int height_ = 0;
};

}  // namespace jostle::physics
