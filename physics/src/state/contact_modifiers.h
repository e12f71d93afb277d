// SPDX-License-Identifier: MIT
//
// Contact properties of two shapes: from their materials, or from a listener when the manifold
// began (ContactModifier).
#pragma once

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Returns the properties from the materials of two shapes; `contact` is not set.
ContactModifier material_modifier(const ShapedBodies& stores, std::uint32_t shape_a,
                                  std::uint32_t shape_b);
// Returns the properties of a contact. Those of a listener take precedence over the materials.
ContactModifier modifier_of(const ContactGraph& stores, const Contact& contact);

// Sets the modifier when the manifold begins.
void set_modifier(ContactStore& contacts, const ContactModifier& modifier);
// Removes the modifier when the manifold ends. No effect if there is none.
void clear_modifier(ContactStore& contacts, std::uint32_t contact);

// Returns whether two shapes pass through each other because of a listener: all of their manifolds
// must be disabled.
bool pass_through(const ContactStore& contacts, const Contact& pair);

}  // namespace jostle::physics
