// SPDX-License-Identifier: MIT
//
// The shapes of a TOI body on its remaining path. A body with many shapes has a tree of their swept
// boxes. Part of solve_continuous.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/continuous/toi_body.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {

// Returns the record of a TOI body's shapes. Computes it on first use after a change of the path.
const SweptShapes& swept_shapes_of(const WorldState& world, ToiBody& t);

// Calls visit(shape) for the shapes of a TOI body that may come within `gap` metres of a swept
// shape, in the order of the body. Visits all shapes if there are few.
template <class Visit>
void for_each_shape_near(const WorldState& world, ToiBody& t, const SweptShape& other, double gap,
                         Visit&& visit) {
    const SweptShapes& swept = swept_shapes_of(world, t);
    const double from = std::max(t.sweep.from, other.sweep.from), until = other.sweep.until;
    if (swept.tree.empty() || kind_of(*other.geometry) == ShapeKind::plane || from > until) {
        for (std::uint32_t own = world.bodies.cold[t.body].first_shape; own != none;
             own = world.shapes.shapes[own].next)
            visit(own);
        return;
    }
    const double margin = 6 * gap + tuning::swept_margin;
    std::vector<std::uint32_t> near;
    swept.tree.query(grow(swept_bounds(other, from, until), margin),
                     [&](std::uint32_t k) { near.push_back(k); });
    std::sort(near.begin(), near.end());
    for (const std::uint32_t k : near) visit(swept.shapes[k]);
}

}  // namespace jostle::physics
