// SPDX-License-Identifier: MIT
//
// Changes of the tier and the batch of islands. Contacts move between sets, and impulses are scaled
// with the length of the sub-steps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Returns the awake islands that manifolds couple to this one, itself first. Coupled islands share
// one colour set. Manifolds may couple islands that do not touch yet.
std::vector<std::uint32_t> coupled_islands(const BodySets& sets, const ContactStore& contacts,
                                           std::uint32_t island);
// The same if they have at most `max_bodies` bodies, otherwise none. The time depends on that
// number only.
std::vector<std::uint32_t> few_coupled_islands(const BodySets& sets, const ContactStore& contacts,
                                               std::uint32_t island, std::uint32_t max_bodies);

// The same for all islands at once, in time that is independent of the number of queries. Valid
// until a manifold begins or ends; sets may change.
class CoupledIslands {
public:
    explicit CoupledIslands(const ContactGraph& stores);
    // Returns the coupled islands in ascending order. Sleeping islands are not coupled.
    std::span<const std::uint32_t> group_of(std::uint32_t island) const {
        const std::uint32_t first = first_[island];
        return std::span(members_).subspan(start_[first], start_[first + 1] - start_[first]);
    }

private:
    std::vector<std::uint32_t> first_;    // by island: first island of its group
    std::vector<std::uint32_t> start_;    // by first island of a group: start in members_
    std::vector<std::uint32_t> members_;  // islands, group by group
};

// Moves islands to another set. `islands` are all islands of one coupling.
void move_to_set(ContactGraph& stores, JointStore& joints, std::span<const std::uint32_t> islands,
                 ColourSetKey set);

// Multiplies all warm-start impulses of an awake island.
void scale_warm_start(ContactGraph& stores, const Island& island, float scale);

// Call before two awake islands become coupled: assigns both the same colour set, that of the
// higher tier, or that of the larger island if the tiers differ only in how contacts learn.
void match_sets(ContactGraph& stores, JointStore& joints, std::uint32_t a, std::uint32_t b);

}  // namespace jostle::physics
