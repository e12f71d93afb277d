// SPDX-License-Identifier: MIT
//
// The swept boxes of all bodies that were fast in this step, in a tree. Two bodies may have
// collided at a place that both have left, which the trees of shapes do not show.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/collision/broadphase/dynamic_tree.h"

namespace jostle::physics {

class SweptAabbTree {
public:
    bool empty() const { return leaf_.empty(); }
    bool has(std::uint32_t body) const {
        return body < leaf_.size() && leaf_[body] != DynamicTree::null_node;
    }

    // Inserts all bodies: box_of(body) returns a body's box. Each body occurs once.
    template <class MotionOf>
    void set_all(const std::vector<std::uint32_t>& bodies, MotionOf&& box_of) {
        for (const std::uint32_t body : bodies) {
            if (body >= leaf_.size()) leaf_.resize(body + 1, DynamicTree::null_node);
            ASSERT(!has(body));
            leaf_[body] = tree_.add(box_of(body), body);
        }
        tree_.rebuild();
    }

    // Sets the box of a body's path, or of its remaining path.
    void set(std::uint32_t body, const Aabb& box) {
        if (body >= leaf_.size()) leaf_.resize(body + 1, DynamicTree::null_node);
        if (has(body))
            tree_.move(leaf_[body], box);
        else
            leaf_[body] = tree_.insert(box, body);
    }

    template <class Visit>
    void query(const Aabb& box, Visit&& visit) const {
        tree_.query(box, ~0u, visit);
    }

private:
    DynamicTree tree_;
    std::vector<std::int32_t> leaf_;  // indexed by body
};

}  // namespace jostle::physics
