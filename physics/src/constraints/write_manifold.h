// SPDX-License-Identifier: MIT
//
// Fills a lane from a manifold: geometry, effective masses, material, and the impulses that its
// points carried before.
#pragma once

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// The contact has a lane. `fresh`: it was just taken and holds nothing to keep. May run on many
// threads for different contacts at once.
void write_manifold(WorldState& world, const Contact& contact, const Manifold& manifold,
                    bool fresh);

// Which body the point of contact travels with: 0 is a, 1 is b, between them both. It goes along
// with a round body that rolls on a flat one; of two alike it stays between them. What is not
// pushed need not be thought of.
double anchor_blend_of(const WorldState& world, const Contact& contact);

}  // namespace jostle::physics
