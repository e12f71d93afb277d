// SPDX-License-Identifier: MIT
//
// How the two shapes of a contact touch: as their materials give it, or as a listener answered when
// its manifold began (ContactModifier).
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// As the materials of two shapes give it now; `contact` is not set.
ContactModifier material_modifier(const WorldState& world, std::uint32_t shape_a,
                                  std::uint32_t shape_b);
// As it is for a contact: what a listener said counts before the materials.
ContactModifier modifier_of(const WorldState& world, const Contact& contact);

// From the beginning of a manifold ...
void set_modifier(WorldState& world, const ContactModifier& modifier);
// ... to its end. Does nothing when there is none.
void clear_modifier(WorldState& world, std::uint32_t contact);

// Whether two shapes pass through each other by what a listener answered: of several manifolds by
// all.
bool pass_through(const WorldState& world, const Contact& pair);

}  // namespace jostle::physics
