// SPDX-License-Identifier: MIT
//
// Contact manifolds in the form of the public API, for manifolds of awake and sleeping contacts.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/world.h"
#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Return the manifold of a contact in the constraint graph, and of one stored by a sleeping island.
ContactInfo solved_contact(const ContactGraph& stores, std::uint32_t contact);
ContactInfo sleeping_contact(const ContactGraph& stores, const SavedContact& saved);

// The contacts of a body that have manifolds.
struct ContactView {
    std::uint32_t contact = 0;  // index
    ContactInfo info;
};
std::vector<ContactView> contacts_on(const ContactGraph& stores, std::uint32_t body);

}  // namespace jostle::physics
