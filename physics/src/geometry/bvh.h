// SPDX-License-Identifier: MIT
//
// A static bounding-volume tree over items given by their boxes: triangles of a mesh, children of a
// compound. Built once by splitting at the best of a few planes (surface area heuristic, binned:
// Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007); items of a leaf are
// in rising order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/aabb.h"

namespace jostle::physics {

class Bvh {
public:
    Bvh() = default;
    explicit Bvh(std::span<const Aabb> boxes);

    bool empty() const { return nodes_.empty(); }
    int height() const { return height_; }

    // Calls visit(item) for every item whose leaf's box overlaps; the caller tests the item itself.
    template <class Visit>
    void query(const Aabb& box, Visit&& visit) const {
        if (nodes_.empty()) return;
        std::uint32_t stack[stack_size];
        int top = 0;
        stack[top++] = 0;
        while (top > 0) {
            const Node& n = nodes_[stack[--top]];
            if (!overlap(n.box, box)) continue;
            if (n.count > 0) {
                for (std::uint32_t k = 0; k < n.count; k++) visit(items_[n.first + k]);
            } else {
                stack[top++] = n.first + 1;
                stack[top++] = n.first;
            }
        }
    }

    // Calls visit(item, limit) for items whose leaf the segment meets within [0, limit]; visit
    // returns the new limit.
    template <class Visit>
    void cast_ray(Vec3 origin, Vec3 motion, double limit, Visit&& visit) const {
        if (nodes_.empty()) return;
        std::uint32_t stack[stack_size];
        int top = 0;
        stack[top++] = 0;
        while (top > 0) {
            const Node& n = nodes_[stack[--top]];
            if (ray_enters(n.box, origin, motion, limit) > limit) continue;
            if (n.count > 0) {
                for (std::uint32_t k = 0; k < n.count; k++)
                    limit = visit(items_[n.first + k], limit);
                continue;
            }
            // The nearer child first.
            const double left = ray_enters(nodes_[n.first].box, origin, motion, limit);
            const double right = ray_enters(nodes_[n.first + 1].box, origin, motion, limit);
            const bool left_first = left <= right;
            stack[top++] = left_first ? n.first + 1 : n.first;
            stack[top++] = left_first ? n.first : n.first + 1;
        }
    }

private:
    static constexpr int max_height = 60;
    static constexpr int stack_size = max_height + 4;
    struct Node {
        Aabb box;
        std::uint32_t first = 0;  // leaf: of its items; else the left child, the right one is next
        std::uint32_t count = 0;  // items of a leaf; 0: not a leaf
    };
    void split(std::uint32_t node, std::span<const Aabb> boxes, int depth);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;
    int height_ = 0;
};

}  // namespace jostle::physics
