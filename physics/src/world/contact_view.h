// SPDX-License-Identifier: MIT
//
// A contact's manifold as the public face shows it, wherever it is kept.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/world.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Of a contact in the constraint graph, and of one that a sleeping island keeps.
ContactInfo solved_contact(const WorldState& world, std::uint32_t contact);
ContactInfo sleeping_contact(const WorldState& world, const SavedContact& saved);

// A body's contacts that have manifolds.
struct ContactView {
    std::uint32_t contact = 0;  // index
    ContactInfo info;
};
std::vector<ContactView> contacts_on(const WorldState& world, std::uint32_t body);

}  // namespace jostle::physics
