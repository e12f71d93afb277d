// SPDX-License-Identifier: MIT
//
// Which shapes have a contact, and which contacts a body has. Every contact is created and
// destroyed here, and begins and ends to touch here, so that the lists of bodies, the islands and
// the constraint graph agree; state/validate.h checks that they do.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// A new contact with a separation bound that is due: it is looked at in the next step. Orders the
// shapes so that a is dynamic.
std::uint32_t create_contact(WorldState& world, std::uint32_t shape_a, std::uint32_t shape_b);
// A manifold of a composite pair; it is not in the constraint graph yet.
std::uint32_t create_child_contact(WorldState& world, std::uint32_t parent, std::uint64_t key);
// Destroys its parts, takes it out of the constraint graph, ends its touch and reports the end (to
// `ended`) when it was touching.
void destroy_contact(WorldState& world, std::uint32_t contact, std::vector<ContactEnd>& ended);
void destroy_contacts_of(WorldState& world, std::uint32_t body, std::vector<ContactEnd>& ended);
void destroy_contacts_of_shape(WorldState& world, std::uint32_t shape,
                               std::vector<ContactEnd>& ended);
// All contacts between two bodies.
void destroy_contacts_between(WorldState& world, std::uint32_t body, std::uint32_t other,
                              std::vector<ContactEnd>& ended);

// Begins or ends the bond that a touching contact is. A body asleep in place that loses a touch is
// filed to be woken.
void begin_touch(WorldState& world, std::uint32_t contact);
void end_touch(WorldState& world, std::uint32_t contact);

void report_end(const WorldState& world, const Contact& contact, std::vector<ContactEnd>& ended);
// Ends the touch of a composite pair none of whose parts touches any more, and reports it.
void end_touch_of_pair(WorldState& world, std::uint32_t pair, std::vector<ContactEnd>& ended);

}  // namespace jostle::physics
