// SPDX-License-Identifier: MIT
//
// Contacts as edges between shapes and bodies. All contacts are created and destroyed in this file,
// and begin and end to touch in it, so that the lists of bodies, the islands and the constraint
// graph agree; state/validate.h verifies it.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Creates a contact with a separation bound that is due, so that it is tested in the next step.
// Orders the shapes so that body a is dynamic.
std::uint32_t create_contact(ContactGraph& stores, std::uint32_t shape_a, std::uint32_t shape_b);
// Creates a manifold contact of a composite pair. It is not in the constraint graph yet.
std::uint32_t create_child_contact(ContactGraph& stores, std::uint32_t parent, std::uint64_t key);
// Destroys a contact with its children, removes it from the constraint graph, ends its touch, and
// appends the end to `ended` if it was touching.
void destroy_contact(WorldState& world, std::uint32_t contact, std::vector<ContactEnd>& ended);
void destroy_contacts_of(WorldState& world, std::uint32_t body, std::vector<ContactEnd>& ended);
void destroy_contacts_of_shape(WorldState& world, std::uint32_t shape,
                               std::vector<ContactEnd>& ended);
// Destroys all contacts between two bodies.
void destroy_contacts_between(WorldState& world, std::uint32_t body, std::uint32_t other,
                              std::vector<ContactEnd>& ended);

// Begins or ends the touch of a contact, which connects islands. A body asleep in place that loses
// a touch gets a wake request.
void begin_touch(ContactGraph& stores, JointStore& joints, std::uint32_t contact);
void end_touch(WorldState& world, std::uint32_t contact);

void report_end(const ShapedBodies& stores, const Contact& contact, std::vector<ContactEnd>& ended);
// Ends the touch of a composite pair whose children no longer touch, and reports it.
void end_touch_of_pair(ContactGraph& stores, std::uint32_t pair, std::vector<ContactEnd>& ended);

}  // namespace jostle::physics
