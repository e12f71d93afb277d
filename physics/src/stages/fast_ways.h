// SPDX-License-Identifier: MIT
//
// The ways of all bodies that were fast in this step, as boxes in a tree: two may meet where
// neither is any more, so the trees of shapes do not know it.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "collision/broadphase/dynamic_tree.h"

namespace jostle::physics {

class FastWays {
public:
    bool empty() const { return leaf_.empty(); }

    // The box of a body's way, or of what is left of it.
    void set(std::uint32_t body, const Aabb& box) {
        const auto [known, fresh] = leaf_.try_emplace(body, DynamicTree::null_node);
        if (fresh)
            known->second = tree_.insert(box, body);
        else
            tree_.move(known->second, box);
    }

    template <class Visit>
    void query(const Aabb& box, Visit&& visit) const {
        tree_.query(box, ~0u, visit);
    }

private:
    DynamicTree tree_;
    std::unordered_map<std::uint32_t, std::int32_t> leaf_;  // looked up, never walked
};

}  // namespace jostle::physics
