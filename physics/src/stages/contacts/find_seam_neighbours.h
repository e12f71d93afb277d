// SPDX-License-Identifier: MIT
//
// The shapes that may form one floor with a shape of a pair: see
// collision/narrowphase/seams.h. Part of the narrow phase; reads contact lists, which do not change
// during it.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Indices of shapes, in the order of the contact list of body a or of the shapes of a body.
struct SeamShapes {
    std::vector<std::uint32_t> of_a, of_b;

    bool empty() const { return of_a.empty() && of_b.empty(); }
};

// The other shapes of the same body that the respective other shape may touch. Bodies that are not
// dynamic count as one body: none of them gives way.
SeamShapes find_seam_neighbours(const ContactGraph& stores, const Contact& contact);

}  // namespace jostle::physics
