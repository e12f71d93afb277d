// SPDX-License-Identifier: MIT
//
// The contacts of a world in its constraint graph. The functions add and remove contacts and update
// the bodies' colour masks and counts, the contacts' slots and the blocks' body indices
// accordingly. Not thread-safe, unless stated otherwise.
#pragma once

#include "physics/src/constraint_graph/effective_mass.h"
#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Returns the colour set of a contact: that of its islands, or that of contacts asleep in place.
ColourSetKey set_of_contact(const BodySets& sets, const Contact& contact);

// Assigns the contact a slot in the lowest colour of its set that is free for both dynamic bodies.
// Both bodies are awake or static, and their islands have the same colour set. The lane is empty;
// constraints/write_manifold.h fills it, with one point if `single`.
void add_contact(ContactGraph& stores, std::uint32_t contact, bool single);
void remove_contact(ContactGraph& stores, std::uint32_t contact);

// Copies the content of a lane out of the graph, and back.
SavedContact save_contact(const ContactGraph& stores, std::uint32_t contact);
void restore_contact(ContactGraph& stores, const SavedContact& saved);  // adds the contact first

// Moves the contact to the set, colour and list to which it belongs now.
void move_contact(ContactGraph& stores, std::uint32_t contact);
// After a manifold was rebuilt: returns whether it is in the list for its number of points.
bool is_in_its_list(const ConstraintGraph& graph, const Contact& contact);
// Moves it to that list if necessary.
void move_to_its_list(ContactGraph& stores, std::uint32_t contact);

ContactLaneRef lane_ref_of(ConstraintGraph& graph, const Contact& contact);
// Read-only access.
ContactLaneRef lane_ref_of(const ConstraintGraph& graph, const Contact& contact);

// Writes the hot indices of the contact's bodies to its lane. Call it after the contact was added
// or a body moved within the awake set.
void write_body_indices(const BodyStore& bodies, ConstraintGraph& graph, const Contact& contact);
// Sets the flags of the lane that are derived from bodies and shapes. Call it after the contact was
// added or loaded.
void derive_flags(ContactGraph& stores, const Contact& contact);

// Sorts a colour by the order of its bodies. Colours of one set may be sorted concurrently.
void sort_contacts(ContactStore& contacts, GraphColour& colour, int number);

// Thread-safe for different contacts: these write only floats of the contact's lane.
void write_effective_mass(const BodySets& sets, ConstraintGraph& graph, const Contact& contact,
                          const ContactFrame& frame);
void rewrite_effective_mass(const BodySets& sets, ConstraintGraph& graph, const Contact& contact);

}  // namespace jostle::physics
