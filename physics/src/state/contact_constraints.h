// SPDX-License-Identifier: MIT
//
// A world's contacts in its constraint graph: adds and removes them, and keeps the bodies' colour
// masks and counts, the contacts' slots and the blocks' body indices in step with it. Called
// serially but for what says otherwise.
#pragma once

#include "physics/src/constraint_graph/effective_mass.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Which colour set a contact belongs to: its islands', or that of what sleeps in place.
ColourSetKey set_of_contact(const WorldState& world, const Contact& contact);

// Gives the contact a slot in the lowest colour of its set that both dynamic bodies have free. Both
// bodies are awake or static, and their islands have one colour set. The lane is empty:
// constraints/write_manifold.h fills it, with one point if `single`.
void add_contact(WorldState& world, std::uint32_t contact, bool single);
void remove_contact(WorldState& world, std::uint32_t contact);

// A lane's content outside the graph and back again.
SavedContact save_contact(const WorldState& world, std::uint32_t contact);
void restore_contact(WorldState& world, const SavedContact& saved);  // adds the contact first

// From wherever it is to the set, colour and list where it belongs now.
void move_contact(WorldState& world, std::uint32_t contact);
// After a manifold was rebuilt: whether it is in the list of its number of points, ...
bool is_in_its_list(const WorldState& world, const Contact& contact);
// ... and goes there.
void move_to_its_list(WorldState& world, std::uint32_t contact);

ContactLaneRef lane_ref_of(WorldState& world, const Contact& contact);
// To read it.
ContactLaneRef lane_ref_of(const WorldState& world, const Contact& contact);

// Writes the hot indices of the contact's bodies into its lane: after it was added or a body moved
// in the awake set.
void write_body_indices(WorldState& world, const Contact& contact);
// Sets the flags of its lane that follow from its bodies and shapes: after it was added or loaded.
void derive_flags(WorldState& world, const Contact& contact);

// Brings a colour into the order of its bodies. Colours of one set may be sorted at the same time.
void sort_contacts(WorldState& world, GraphColour& colour, int number);

// For many threads: write only floats of the contact's own lane.
void write_effective_mass(WorldState& world, const Contact& contact, const ContactFrame& frame);
void rewrite_effective_mass(WorldState& world, const Contact& contact);

}  // namespace jostle::physics
