// SPDX-License-Identifier: MIT
//
// Islands: dynamic bodies that hang together by touching contacts. Kept from step to step: joined
// when a contact begins to touch, split when something in it has come to rest and contacts have
// ended since. A sleeping island owns its bodies' warm records and manifolds, so that the awake
// arrays hold only what moves.
#pragma once

#include <cstdint>
#include <vector>

#include "foundation/id_pool.h"
#include "state/body_store.h"
#include "state/manifold_store.h"

namespace jostle::physics {

struct Island {
    std::uint32_t first = none, last = none;  // bodies, through BodyCold::island_next
    std::uint32_t bodies = 0;
    bool may_be_split = false;  // a touching contact ended since it was formed
    bool asleep = false;
    std::vector<BodyWarm> sleepers;        // when asleep, in the order of the list
    std::vector<SavedManifold> manifolds;  // when asleep
};

struct IslandStore {
    IdPool ids;
    std::vector<Island> islands;
};

}  // namespace jostle::physics
