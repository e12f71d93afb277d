// SPDX-License-Identifier: MIT
//
// Fills a lane from a manifold: geometry, effective masses, material, and the impulses that its
// points carried before.
#pragma once

#include "collision/narrowphase/manifold.h"
#include "state/world_state.h"

namespace jostle::physics {

// The contact has a lane. `fresh`: it was just taken and holds nothing to keep. May run on many
// threads for different contacts at once: it writes floats of its own lane only (see
// finish_manifold).
void write_manifold(WorldState& world, const Contact& contact, const Manifold& manifold,
                    bool fresh);

// The bits that lanes of one block share in a byte; serially, after write_manifold.
void finish_manifold(WorldState& world, const Contact& contact);

}  // namespace jostle::physics
