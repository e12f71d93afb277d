// SPDX-License-Identifier: MIT
//
// Writes a manifold into a lane: geometry, effective masses, material, and the impulses that its
// points had before.
#pragma once

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// The contact must have a lane. `fresh`: the lane was just allocated and holds no impulses.
// Thread-safe for different contacts.
void write_manifold(ContactGraph& stores, const Contact& contact, const Manifold& manifold,
                    bool fresh);

// The body that the contact point moves with: 0 for a, 1 for b, intermediate values blend. The
// point follows a round body that rolls on a flat one; between two similar bodies it stays in the
// middle. Bodies that cannot be pushed are irrelevant.
double anchor_blend_of(const ShapedBodies& stores, const Contact& contact);

}  // namespace jostle::physics
