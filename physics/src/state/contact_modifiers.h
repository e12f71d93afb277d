// SPDX-License-Identifier: MIT
//
// Contact properties of two shapes: from their materials, or from a listener when the manifold
// began (ContactModifier).
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Returns the properties from the materials of two shapes; `contact` is not set.
ContactModifier material_modifier(const WorldState& world, std::uint32_t shape_a,
                                  std::uint32_t shape_b);
// Returns the properties of a contact. Those of a listener take precedence over the materials.
ContactModifier modifier_of(const WorldState& world, const Contact& contact);

// Sets the modifier when the manifold begins.
void set_modifier(WorldState& world, const ContactModifier& modifier);
// Removes the modifier when the manifold ends. No effect if there is none.
void clear_modifier(WorldState& world, std::uint32_t contact);

// Returns whether two shapes pass through each other because of a listener: all of their manifolds
// must be disabled.
bool pass_through(const WorldState& world, const Contact& pair);

}  // namespace jostle::physics
