// SPDX-License-Identifier: MIT
//
// The force at a contact: current, and stored when one of its bodies fell asleep in place. A change
// wakes the sleeping body.
#pragma once

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Returns the force on body b of a contact in the constraint graph, N.
Vec3 load_of(const ContactGraph& stores, const Contact& contact);

void save_load(ContactGraph& stores, std::uint32_t contact);
Vec3 saved_load(const Contact& contact);
// The mass whose weight equals the stored force, kg; 0 without gravity.
double supported_mass(const WorldDef& def, const Contact& contact);

}  // namespace jostle::physics
