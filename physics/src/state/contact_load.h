// SPDX-License-Identifier: MIT
//
// The force at a contact, now and when one of its bodies fell asleep in place: what sleeps wakes
// when that has changed.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// The force of a contact in the constraint graph, N, on body b.
Vec3 load_of(const WorldState& world, const Contact& contact);

void save_load(WorldState& world, std::uint32_t contact);
Vec3 saved_load(const Contact& contact);
// What that was the weight of, kg; 0 without gravity.
double supported_mass(const WorldState& world, const Contact& contact);

}  // namespace jostle::physics
