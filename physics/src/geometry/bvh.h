// SPDX-License-Identifier: MIT
//
// A static bounding-volume tree over items given by their boxes: triangles of a mesh, children of a
// compound. Built once by splitting in two at the best of a few planes (surface area heuristic,
// binned: Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007), then kept
// as a tree of fours (Wald, Benthin, Boulos, "Getting rid of packets", 2008): the boxes of a node's
// four children are looked at in one go. Items are visited as the tree of twos would, left before
// right, those of a leaf in rising order.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/geometry/box_lanes.h"

namespace jostle::physics {

class Bvh {
public:
    Bvh() = default;
    explicit Bvh(std::span<const Aabb> boxes);

    bool empty() const { return nodes_.empty(); }
    int height() const { return height_; }  // of the tree of fours

    // Calls visit(item) for every item whose box overlaps, and some that do not by rounding to
    // float: the caller tests the item itself.
    template <class Visit>
    void query(const Aabb& box, Visit&& visit) const {
        if (nodes_.empty()) return;
        const BoxLanes wanted = four_times(box);
        std::uint32_t stack[stack_size];
        int top = 0;
        stack[top++] = 0;
        while (top > 0) {
            const Node& n = nodes_[stack[--top]];
            unsigned lanes = overlapping(wanted, n.boxes);
            if (n.leaf) {
                for (; lanes != 0; lanes &= lanes - 1) visit(n.child[std::countr_zero(lanes)]);
                continue;
            }
            // The first on top.
            while (lanes != 0) {
                const int last = std::bit_width(lanes) - 1;
                stack[top++] = n.child[last];
                lanes &= ~(1u << last);
            }
        }
    }

    // Calls visit(item, limit) for items whose box the segment meets within [0, limit], about the
    // nearest first, and some that it misses by rounding to float; visit returns the new limit.
    template <class Visit>
    void cast_ray(Vec3 origin, Vec3 motion, double limit, Visit&& visit) const {
        const RayOverlap meets(origin, motion);
        nearest_first(
            [&](const BoxLanes& boxes, bool, Float4& key) { return meets(boxes, limit, key); },
            [&](std::uint32_t item) { limit = visit(item, limit); });
    }

    // Of each four, test(boxes, leaf, key) says by bits which are to be gone on with; visit(item)
    // is called for those that are items, which are in leaves. Lower keys first, among the children
    // of a node; of equal ones the left.
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
    static constexpr int max_height = 60;                  // of the tree of twos
    static constexpr int stack_size = 3 * max_height + 4;  // a node that is taken off puts four on
    struct alignas(64) Node {
        BoxLanes boxes;
        std::uint32_t child[4] = {};  // items of a leaf, else nodes
        bool leaf = false;
    };
    struct Two;
    void split(std::vector<Two>& twos, std::uint32_t node, std::span<const Aabb> boxes, int depth);
    void keep(const std::vector<Two>& twos, std::uint32_t node, std::span<const Aabb> boxes,
              int depth);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;  // while it is built
    int height_ = 0;
};

}  // namespace jostle::physics
