// SPDX-License-Identifier: MIT
//
// Deformables of a module that may touch each other in a step. They advance together, led by the
// first of them, so that one thread or one group of sub-steps owns all of them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "jostle/physics/aabb.h"

namespace jostle::modules {

/// Where a deformable may be in a step.
struct Reach {
    bool awake = false;
    physics::Aabb box = {};  ///< m
};

/// The groups of a step. Indices are those of the reaches.
class Companions {
public:
    /// Whether a part of the first, awake deformable that moves may touch the second one.
    using MovesInto = std::function<bool(std::uint32_t, std::uint32_t)>;

    /// Wakes those that sleep and into which another one moves, and groups those that are awake and
    /// whose boxes overlap.
    void find(std::span<const Reach> reaches, const MovesInto& moves_into);

    bool is_woken(std::uint32_t k) const { return woken_[k]; }
    /// The first of the group; itself if it is alone or asleep.
    std::uint32_t leader(std::uint32_t k) const;
    /// Pairs of a leader and a sleeping deformable near its group, sorted, each once.
    std::span<const std::pair<std::uint32_t, std::uint32_t>> obstacles() const {
        return obstacles_;
    }
    /// Gives the deformables, in the order of their reaches, their leader (null: they lead),
    /// companions and obstacles. Calls `wake` with those that are woken.
    template <class Deformable, class Wake>
    void assign(std::span<Deformable* const> deformables, const Wake& wake) const {
        for (std::uint32_t k = 0; k < deformables.size(); k++) {
            if (is_woken(k)) wake(*deformables[k]);
            Deformable* const first = deformables[leader(k)];
            if (first == deformables[k]) continue;
            deformables[k]->leader = first;
            first->companions.push_back(deformables[k]);
        }
        for (const auto& [first, obstacle] : obstacles_)
            deformables[first]->obstacles.push_back(deformables[obstacle]);
    }

private:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    std::vector<bool> awake_, woken_;
    std::vector<Pair> pairs_, obstacles_;
    std::vector<std::uint32_t> parents_;
};

}  // namespace jostle::modules
